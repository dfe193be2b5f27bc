// SPDX-License-Identifier: Apache-2.0
// Fewer points for the same line, and no lines too short to be felt.
#include <algorithm>
#include <cmath>

#include "tactics/filter.h"
#include "tactics/geometry/course.h"

namespace tactics {

namespace {

constexpr Option kSimplifyOptions[] = {
    {.name = "tolerance",
     .type = Option::Type::length,
     .fallback = 0.1,
     .min = 0,
     .max = 20,
     .unit = "mm",
     .summary = "how far the new line may lie from the old one"},
    {.name = "shortest",
     .type = Option::Type::length,
     .fallback = 0,
     .min = 0,
     .max = 100,
     .unit = "mm",
     .summary = "lines shorter than this are left out"},
};

std::size_t farthest_from(const std::vector<Point>& points, Point from) {
    std::size_t found = 0;
    double most = -1;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const double d = std::hypot(points[i].x - from.x, points[i].y - from.y); d > most) {
            most = d;
            found = i;
        }
    return found;
}

void simplify(std::vector<Point>& points, bool closed, double tolerance) {
    if (points.size() < (closed ? 4u : 3u)) return;
    if (closed) {
        // A loop is two lines between two points far from each other; the first one is repeated while it is cut open.
        const std::size_t start = farthest_from(points, points.front());
        std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(start), points.end());
        points.push_back(points.front());
    }
    const std::size_t last = points.size() - 1;
    std::vector<bool> keep(points.size(), false);
    keep[0] = keep[last] = true;
    if (closed) {
        const std::size_t across = std::max<std::size_t>(1, farthest_from(points, points.front()));
        keep[across] = true;
        keep_course(points, 0, across, tolerance, keep);
        keep_course(points, across, last, tolerance, keep);
        if (std::count(keep.begin(), keep.end(), true) < 4) {  // a loop stays a loop, however thin
            std::size_t third = last;
            double most = -1;
            for (std::size_t i = 1; i < last; ++i)
                if (const double d = distance_to_segment(points[i], points[0], points[across]); !keep[i] && d > most) {
                    most = d;
                    third = i;
                }
            keep[third] = true;
        }
    } else {
        keep_course(points, 0, last, tolerance, keep);
    }
    std::size_t to = 0;
    for (std::size_t i = 0; i <= last; ++i)
        if (keep[i]) points[to++] = points[i];
    points.resize(closed ? to - 1 : to);
}

Artwork apply_simplify(Artwork artwork, const Settings& settings) {
    auto& drawing = std::get<Drawing>(artwork);
    const double tolerance = settings.number("tolerance"), shortest = settings.number("shortest");
    for (Stroke& stroke : drawing.strokes) simplify(stroke.points, stroke.closed, tolerance);
    std::erase_if(drawing.strokes, [shortest](const Stroke& stroke) { return length_of(stroke) < shortest; });
    for (Area& area : drawing.areas)
        for (auto& ring : area.rings) simplify(ring, true, tolerance);
    return artwork;
}

}  // namespace

extern const Filter simplify_filter;
const Filter simplify_filter{
    .name = "simplify",
    .summary = "draws the same lines with fewer points; leaves out lines too short to feel",
    .takes = static_cast<Kinds>(Kind::drawing),
    .gives = static_cast<Kinds>(Kind::drawing),
    .options = kSimplifyOptions,
    .apply = apply_simplify,
};

}  // namespace tactics
