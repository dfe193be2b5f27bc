// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/line_styles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/geometry/course.h"
#include "tactics/geometry/shape.h"
#include "tactics/geometry/walk.h"
#include "tactics/page.h"

namespace tactics {

namespace {

constexpr double kDash = 8, kDashInCells = 10;          // mm
constexpr double kGapInCells = 5.4;                     // mm: dots that move half of 3.5 mm to the nearest column leave one empty
constexpr double kBent = 1.05;                          // on a curve it is less far straight across than along the line
constexpr double kDotStroke = 0.02;                     // mm: a stroke needs two places
constexpr std::size_t kLooksBack = 3;                   // marks
constexpr double kLater = 0.25, kLaterRounding = 1e-6;  // mm
constexpr std::size_t kMostMarks = 20'000;              // of a line; a large page has room for far fewer

struct Marks {
    std::vector<double> lengths;  // of their middle lines
    double gap = 0;               // from the end of one to the beginning of the next

    double total() const {
        double sum = gap * (static_cast<double>(lengths.size()) - 1);
        for (const double length : lengths) sum += length;
        return sum;
    }
};

// As many as come nearest to the line's length.
Marks marks_for(double length, const LineStyle& style, double width, double least_gap) {
    Marks marks{{}, std::max(style.gap + width, least_gap)};
    const auto middle = [&](std::size_t i) { return std::max(kDotStroke, style.marks[i % style.marks.size()] - width); };
    double total = middle(0);
    marks.lengths.push_back(middle(0));
    while (marks.lengths.size() < kMostMarks) {
        const double more = marks.gap + middle(marks.lengths.size());
        if (total + more / 2 > length) break;
        total += more;
        marks.lengths.push_back(middle(marks.lengths.size()));
    }
    return marks;
}

// Longer gaps where there is more room, shorter dashes where there is less; dots stay dots.
void stretch(Marks& marks, double length) {
    double ink = 0;
    for (const double mark : marks.lengths) ink += mark > kDotStroke ? mark : 0;
    const auto gaps = static_cast<double>(marks.lengths.size() - 1);
    const double dots = marks.total() - ink - gaps * marks.gap, more = length - marks.total();
    if (more > 0 && gaps > 0) {
        const double share = ink > 0 ? marks.gap * gaps / (marks.gap * gaps + ink) : 1;
        marks.gap += more * share / gaps;
    }
    const double left = std::max(0.0, length - dots - gaps * marks.gap);
    for (double& mark : marks.lengths)
        if (mark > kDotStroke) mark *= left / ink;
}

// From one mark to another, mm; they do not cross.
double least_between(const std::vector<Point>& a, const std::vector<Point>& b) {
    double least = INFINITY;
    for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}})
        for (const Point& p : *one)
            for (std::size_t i = 0; i + 1 < other->size(); ++i)
                least = std::min(least, distance_to_segment(p, (*other)[i], (*other)[i + 1]));
    return least;
}

}  // namespace

LineStyle line_style(std::size_t number, const Medium& medium) {
    const bool cells = has_fixed_dots(medium), thick = medium.thick_line > medium.line;
    const double dash = cells ? kDashInCells : kDash, gap = cells ? kGapInCells : std::max(dash / 2, kBent * medium.gap),
                 dots = cells ? kGapInCells : kBent * medium.gap;
    switch (number % kLineStyles) {
        case 1: return {LineClass::normal, {dash}, gap};
        case 2: return thick ? LineStyle{LineClass::thick} : LineStyle{LineClass::normal, {dash, 0}, gap};
        case 3: return {LineClass::thick, {0}, dots};
        case 4: return thick ? LineStyle{LineClass::thick, {dash}, gap} : LineStyle{LineClass::normal, {dash, 0, 0}, gap};
        default: return {};
    }
}

double sample_length(const Medium& medium) {
    // Two dashes with all that stands between them.
    double longest = 0;
    for (std::size_t i = 0; i < kLineStyles; ++i) {
        const LineStyle style = line_style(i, medium);
        if (style.is_whole()) continue;
        double period = 0;
        for (const double mark : style.marks) period += std::max(mark, width_of(style.line, medium)) + style.gap;
        longest = std::max(longest, period + style.marks[0]);
    }
    return longest;
}

std::vector<Stroke> in_style(const std::vector<Point>& points, bool closed, const LineStyle& style, const Medium& medium) {
    if (style.is_whole()) return {{points, closed, style.line}};
    const double length = length_of(points, closed), width = width_of(style.line, medium);
    const double least_gap = (has_fixed_dots(medium) ? kGapInCells : kBent * medium.gap) + width;
    const double straight = least_apart(medium, width, width);
    Marks marks = marks_for(closed ? length - least_gap : length, style, width, least_gap);
    while (marks.lengths.size() > 1 && marks.total() > length) {
        double shortest = 0;  // what is left if dashes are as short as they may be
        for (const double mark : marks.lengths) shortest += mark > kDotStroke ? 0.75 * mark : mark;
        if (shortest + marks.gap * (static_cast<double>(marks.lengths.size()) - 1) <= length) break;
        marks.lengths.pop_back();
    }
    stretch(marks, closed ? length - marks.gap : length);
    const double end = closed ? length - least_gap : length;  // of a closed line a gap is behind the last mark
    std::vector<Stroke> strokes;
    double along = marks.lengths.size() == 1 ? std::max(0.0, length - marks.lengths[0]) / 2 : 0;
    for (const double mark : marks.lengths) {
        double from = std::max(0.0, std::min(along, end - mark)), to = std::min(end, from + mark);
        along += mark + marks.gap;
        // Around a corner it is less far straight across: a dash begins later, a dot stands farther on.
        const auto too_near = [&] {
            const std::vector<Point> here = part_of(points, closed, from, to);
            const std::size_t first = strokes.size() > kLooksBack ? strokes.size() - kLooksBack : 0;
            for (std::size_t i = first; i < strokes.size(); ++i)
                if (least_between(strokes[i].points, here) < straight - kLaterRounding) return true;
            return false;
        };
        while (too_near() && from + kLater < end) {
            from += kLater;
            to = std::max(to, std::min(end, from + kDotStroke));
        }
        if (too_near()) continue;
        std::vector<Point> part = part_of(points, closed, from, to);
        if (part.size() > 1) strokes.push_back({std::move(part), false, style.line, 0, Role::dash});
    }
    return strokes;
}

}  // namespace tactics
