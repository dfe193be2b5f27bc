// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/dashed_line.h"

#include <cmath>
#include <iterator>

#include "tactics/geometry/shape.h"
#include "tactics/geometry/vectors.h"

namespace tactics {

namespace {

constexpr double kHeading = 2;  // mm at an end of a dash that tell its direction: a dash may have a corner
constexpr double kLeast = 0.5;  // cosine of 60 degrees: a curve turns within a gap

// The first point of a line that is so far from its beginning; the last one if none is.
template <typename Points>
Point on_from(Points begin, Points end) {
    for (Points at = begin; ++at != end;)
        if (distance(*begin, *at) >= kHeading) return *at;
    return *std::prev(end);
}

}  // namespace

bool goes_on(std::span<const Point> dash, std::span<const Point> next) {
    const Point over = next.front() - dash.back();
    const auto agrees = [&](Point from, Point end) { return cosine(end - from, over) > kLeast; };
    // A corner may be just behind an end, or a step of pixels.
    return (agrees(on_from(dash.rbegin(), dash.rend()), dash.back()) || agrees(dash[dash.size() - 2], dash.back())) &&
           (agrees(next.front(), on_from(next.begin(), next.end())) || agrees(next.front(), next[1]));
}

std::size_t last_of_line(const Page& page, std::size_t first) {
    const auto is_dash = [](const PageStroke& stroke) {
        return stroke.role == Role::dash && !stroke.closed && stroke.points.size() > 1;
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
