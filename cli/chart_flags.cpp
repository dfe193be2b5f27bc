// SPDX-License-Identifier: Apache-2.0
#include "cli/chart_flags.h"

#include <cmath>
#include <string>
#include <string_view>

#include "cli/choice_value.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

SurfaceView surface_view_of(const Given& given) {
    constexpr SurfaceView kAll[] = {SurfaceView::contours, SurfaceView::sections, SurfaceView::heights};
    return kAll[choice_value(given, "--view", {"contours", "sections", "heights"}).value_or(0)];
}

}  // namespace

int levels_value(const Given& given) {
    if (!given.has("--levels")) return 0;
    constexpr double kFewest = 3, kMost = 20;
    const std::string text = given.value("--levels");
    if (text == "auto") return 0;
    const auto number = parse_number(text);
    if (!number || *number != std::round(*number) || *number < kFewest || *number > kMost)
        throw Error(Fault::usage, "--levels",
                    phrase("it cannot be \"{0}\"; it is auto, or a whole number from {1} to {2}", text.substr(0, 80),
                           to_text(kFewest), to_text(kMost)));
    return static_cast<int>(*number);
}

// "y=2,5,8", or, as one might write it too, "x=1,x=3".
SectionWish section_value(const Given& given) {
    SectionWish wish;
    if (!given.has("--section")) return wish;
    const std::string text = given.value("--section");
    char axis = 0;
    for (std::string_view rest = text; !rest.empty();) {
        const auto comma = rest.find(',');
        std::string_view one = rest.substr(0, comma);
        rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
        if (one.size() > 2 && one[1] == '=' && (one[0] == 'x' || one[0] == 'y')) {
            if (axis != 0 && axis != one[0])
                throw Error(Fault::usage, "--section", phrase("sections at x and at y do not share axes; take one of them"));
            axis = one[0];
            one.remove_prefix(2);
        }
        const auto number = parse_number(one);
        if (axis == 0 || !number)
            throw Error(Fault::usage, "--section",
                        phrase("it cannot be \"{0}\"; it is an axis with values, such as y=2,5,8 or x=0.5", text.substr(0, 80)));
        wish.at.push_back(*number);
    }
    wish.at_x = axis == 'x';
    return wish;
}

ChartWish chart_wish(const Given& given) {
    ChartWish wish{given.has("--grid"), surface_view_of(given), levels_value(given), section_value(given)};
    if (given.has("--section") && given.has("--view") && wish.view != SurfaceView::sections)
        throw Error(Fault::usage, "--section", phrase("only --view sections has them; leave one out"));
    if (given.has("--section")) wish.view = SurfaceView::sections;
    if (given.has("--levels") && wish.view != SurfaceView::contours)
        throw Error(Fault::usage, "--levels", phrase("only --view contours has them; leave one out"));
    return wish;
}

}  // namespace tactics
