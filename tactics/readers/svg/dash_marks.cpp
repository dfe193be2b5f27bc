// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/dash_marks.h"

#include <cstddef>
#include <set>

#include "tactics/readers/svg/svg_dashes.h"
#include "tactics/readers/svg/svg_numbers.h"

namespace tactics {

namespace {

// The strokes of a look that are still drawn.
template <typename Visit>
void each_dashed(FoundPage& figure, Visit visit) {
    for (const FoundLook& look : figure.looks)
        for (std::size_t i = look.stroke; i < look.strokes_end; ++i)
            if (PageStroke& stroke = figure.page.strokes[i]; stroke.role == Role::dash && !stroke.points.empty())
                visit(stroke, look.marks);
}

}  // namespace

DashMarks marks_of(std::string_view dashes, std::string_view width) {
    constexpr double kWhole = 100;  // what percentages are of, in both
    // Settings, in line widths. Dots of Matplotlib, R, graphviz and gnuplot are 1 long; a longer mark is one before a gap nearly
    // twice as long. Gnuplot's dashes of 2.5 have gaps of 4, and are none.
    constexpr double kShortDot = 1.7, kLongDot = 2.5, kOfGap = 0.6;
    const Dashes pattern = parse_dashes(dashes, "", kWhole, 1);
    if (pattern.lengths.empty()) return DashMarks::none;
    const double wide = parse_svg_length(width, kWhole).value_or(1);
    std::size_t dots = 0;
    for (std::size_t i = 0; i + 1 < pattern.lengths.size(); i += 2) {
        const double mark = pattern.lengths[i], gap = pattern.lengths[i + 1];
        dots += mark <= kShortDot * wide || (mark <= kLongDot * wide && mark <= kOfGap * gap) ? 1 : 0;
    }
    if (dots == 0) return DashMarks::dashes;
    return dots == pattern.lengths.size() / 2 ? DashMarks::dots : DashMarks::both;
}

void tell_dashes_apart(FoundPage& figure) {
    std::set<DashMarks> kinds;
    each_dashed(figure, [&](const PageStroke&, DashMarks marks) { kinds.insert(marks); });
    if (kinds.size() < 2) return;
    each_dashed(figure, [](PageStroke& stroke, DashMarks marks) {
        stroke.heavy = marks != DashMarks::dashes;
        if (marks == DashMarks::dots) stroke.role = Role::dots;
    });
}

}  // namespace tactics
