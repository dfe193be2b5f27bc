// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/wishes.h"

#include <algorithm>

#include "print/embosser.h"
#include "print/sides.h"
#include "tactics/error.h"

namespace tactics {

namespace {

bool has_sides(const Format& format) {
    return std::any_of(format.options.begin(), format.options.end(),
                       [](const Option& option) { return option.name == kSides.name; });
}

}  // namespace

Settings Wishes::settings_of(const Format& format) const {
    Settings set(format.options);
    for (const auto& [written, values] : settings)
        if (written == &format) set = values;
    if (sheet.duplex && has_sides(format)) set.set(kSides.name, "both", spelled("duplex"), format.name);
    return set;
}

Sheet sheet_for(const Wishes& wishes, const Format& output, const Item& item) {
    const Format& format = output.dots == nullptr && wishes.machine != nullptr ? *wishes.machine : output;
    Sheet sheet = wishes.sheet;
    const bool display = format.dots != nullptr && format.dots(wishes.settings_of(format)).width > 0;
    if (display && (wishes.paper || sheet.margin || sheet.binding))
        throw Error(
            Fault::usage,
            wishes.paper   ? spelled("paper")
            : sheet.margin ? spelled("margin")
                           : spelled("binding"),
            phrase("{0} is a display, all of which is used; leave it out, and see tactics help {0} for its size", format.name));
    sheet.paper = wishes.paper ? *wishes.paper : find_paper(own_paper(format, wishes.settings_of(format)), format.name);
    take_kept(sheet, wishes.kept, format, wishes.paper.has_value(), wishes.settings_of(format));
    if (sheet.medium == nullptr) sheet.medium = &find_medium(format.medium, format.name);
    if (format.dots != nullptr) {
        fit_to_machine(sheet, format, wishes.settings_of(format), wishes.zoom);
    }
    if (format.embosser != nullptr) {
        if (sheet.duplex && !has_sides(format))
            throw Error(Fault::usage, spelled("duplex"),
                        phrase("{0} is made for one side of a sheet; leave it out, or make two jobs", format.name));
        sheet.print_title = false;  // it has no ink
        if (sheet.bare)
            throw Error(Fault::usage, spelled("bare"),
                        phrase("an embosser raises dots on a sheet with margins; leave it out for {0}", format.name));
        const double narrow = sheet.paper.width, wide = sheet.paper.height;
        const Settings settings = wishes.settings_of(format);
        const bool upright = takes_sheet(*format.embosser, settings, narrow, wide),
                   across = takes_sheet(*format.embosser, settings, wide, narrow);
        if (!display && sheet.orientation == Orientation::automatic && upright != across)
            sheet.orientation = upright ? Orientation::portrait : Orientation::landscape;
    }
    if (wishes.title_from_name) {
        sheet.title = stem_of(item.input);
        sheet.title_origin = spelled("title-from-name");
        // "hot_air_balloon.jpg": an underscore stands for a space, and in braille it takes several cells.
        std::replace(sheet.title.begin(), sheet.title.end(), '_', ' ');
    }
    return sheet;
}

bool same_sheet(const Sheet& a, const Sheet& b) {
    return a.paper.width == b.paper.width && a.paper.height == b.paper.height && a.medium == b.medium && a.cell == b.cell &&
           a.bed == b.bed && a.heights == b.heights && a.margin == b.margin && a.reach == b.reach && a.binding == b.binding;
}

}  // namespace tactics
