// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/request.h"

#include <algorithm>
#include <stdexcept>

#include "print/embosser.h"
#include "tactics/error.h"

namespace tactics {

const Settings& Request::settings_of(const Format& format) const {
    for (const auto& [written, values] : settings)
        if (written == &format) return values;
    throw std::logic_error("no settings for " + std::string(format.name));
}

Recipe saved_recipe(const Request& request) {
    const SubjectWish& wish = request.jobs.front().wish;
    const bool same =
        std::all_of(request.jobs.begin(), request.jobs.end(), [&](const Job& job) { return same_wish(job.wish, wish); });
    return same ? with_subject(request.recipe.value(), wish) : request.recipe.value();
}

Sheet sheet_for(const Request& request, const Format& format, const Job& job) {
    Sheet sheet = request.sheet;
    const bool display = format.dots != nullptr && format.dots(request.settings_of(format)).width > 0;
    if (display && (request.paper || sheet.margin || sheet.binding))
        throw Error(Fault::usage,
                    request.paper  ? spelled("paper")
                    : sheet.margin ? spelled("margin")
                                   : spelled("binding"),
                    std::string(format.name) + " is a display, all of which is used; leave it out, and see tactics help " +
                        std::string(format.name) + " for its size");
    sheet.paper = request.paper ? *request.paper : find_paper(format.paper, format.name);
    if (sheet.medium == nullptr) sheet.medium = &find_medium(format.medium, format.name);
    if (format.dots != nullptr) {
        fit_to_machine(sheet, format, request.settings_of(format), request.zoom);
        if (sheet.duplex)
            throw Error(Fault::usage, spelled("duplex"),
                        std::string(format.name) + " is made for one side of a sheet; leave it out, or make two jobs");
    }
    if (format.embosser != nullptr) {
        sheet.print_title = false;  // it has no ink
        if (sheet.bare)
            throw Error(Fault::usage, spelled("bare"),
                        "an embosser raises dots on a sheet with margins; leave it out for " + std::string(format.name));
        const double narrow = sheet.paper.width, wide = sheet.paper.height;
        const bool upright = takes_sheet(*format.embosser, narrow, wide), across = takes_sheet(*format.embosser, wide, narrow);
        if (!display && sheet.orientation == Orientation::automatic && upright != across)
            sheet.orientation = upright ? Orientation::portrait : Orientation::landscape;
    }
    if (request.title_from_name) {
        sheet.title = stem_of(job.input);
        sheet.title_origin = spelled("title-from-name");
        // "hot_air_balloon.jpg": an underscore stands for a space, and in braille it takes several cells.
        std::replace(sheet.title.begin(), sheet.title.end(), '_', ' ');
    }
    return sheet;
}

bool same_sheet(const Sheet& a, const Sheet& b) {
    return a.paper.width == b.paper.width && a.paper.height == b.paper.height && a.medium == b.medium && a.cell == b.cell &&
           a.bed == b.bed;
}

}  // namespace tactics
