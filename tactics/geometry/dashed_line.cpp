// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/dashed_line.h"

#include <cmath>

#include "tactics/geometry/shape.h"

namespace tactics {

namespace {

double cosine(Point a, Point b) {
    const double lengths = std::hypot(a.x, a.y) * std::hypot(b.x, b.y);
    return lengths > 0 ? (a.x * b.x + a.y * b.y) / lengths : 1;
}

// Over the gap in the direction of the dash, and so the next one: not over to the dashes of a line beside it.
bool goes_on(const std::vector<Point>& dash, const std::vector<Point>& next) {
    constexpr double kLeast = 0.5;  // 60 degrees: a curve turns within a gap
    const auto to = [](Point a, Point b) { return Point{b.x - a.x, b.y - a.y}; };
    const Point over = to(dash.back(), next.front());
    return cosine(to(dash.front(), dash.back()), over) > kLeast && cosine(over, to(next.front(), next.back())) > kLeast;
}

}  // namespace

std::size_t last_of_line(const Page& page, std::size_t first) {
    const auto is_dash = [](const PageStroke& stroke) {
        return stroke.role == Role::dash && !stroke.closed && !stroke.points.empty();
    };
    std::size_t last = first;
    while (last + 1 < page.strokes.size() && is_dash(page.strokes[last]) && is_dash(page.strokes[last + 1])) {
        const PageStroke &dash = page.strokes[last], &next = page.strokes[last + 1];
        const double gap = distance(dash.points.back(), next.points.front()) - dash.width;
        if (dash.width != next.width || !goes_on(dash.points, next.points) ||
            gap > kSameLine * (length_of(dash.points, false) + dash.width))
            break;
        ++last;
    }
    return last;
}

std::vector<Point> whole_line(const Page& page, std::size_t first, std::size_t last) {
    std::vector<Point> points;
    for (std::size_t i = first; i <= last; ++i)
        points.insert(points.end(), page.strokes[i].points.begin(), page.strokes[i].points.end());
    return points;
}

}  // namespace tactics
