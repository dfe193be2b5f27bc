// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/output_settings.h"

#include <algorithm>
#include <cmath>

#include "print/embosser.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

Settings settings_for(const Wishes& wishes, const Format& format, const PictureInfo& picture, const Kept& kept) {
    Settings settings = wishes.settings_of(format);
    if (!wishes.sheet.bare || wishes.fixed_dpi || picture.width == 0) return settings;
    const auto set = [&](std::string_view name, double pixels) {
        for (const Option& option : format.options)
            if (option.name == name && option.unit == "pixels")
                settings.set(name, to_text(std::max(1.0, std::round(pixels))), spelled("bare"), format.name);
    };
    set("width", picture.width * kept.width);
    set("height", picture.height * kept.height);
    return settings;
}

void check_machine(const Wishes& wishes, const Format& format, const Sheet& sheet, const Place& place) {
    if (format.embosser == nullptr) return;
    const Settings settings = wishes.settings_of(format);
    const bool turned = sheet.orientation == Orientation::landscape ||
                        (sheet.tiles.several() ? !takes_sheet(*format.embosser, settings, sheet.paper.width, sheet.paper.height)
                                               : place.page_width > place.page_height);
    const double narrow = std::min(sheet.paper.width, sheet.paper.height), wide = std::max(sheet.paper.width, sheet.paper.height);
    check_sheet(*format.embosser, settings, format.name, turned ? wide : narrow, turned ? narrow : wide);
}

}  // namespace tactics
