// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/whole.h"

#include <algorithm>
#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/geometry/course.h"

namespace tactics {

namespace {

// How far inside; negative: the point is outside.
double to_side(const Box& box, Point p) { return std::min({p.x - box.left, p.y - box.top, box.right - p.x, box.bottom - p.y}); }

struct Line {
    Stroke stroke;
    double length = 0;
    Box around = kNothing;
};

std::vector<Line> lines_in(const Drawing& drawing) {
    std::vector<Line> lines;
    const auto add = [&](Stroke stroke) {
        Line& line = lines.emplace_back(Line{std::move(stroke), 0});
        line.length = length_of(line.stroke);
        line.around = box_of(line.stroke.points);
    };
    for (const Stroke& stroke : drawing.strokes)
        if (is_drawn(stroke.role)) add(stroke);
    for (const Area& area : drawing.areas)
        for (const auto& ring : area.rings)
            if (is_drawn(area.role)) add({ring, true});
    return lines;
}

bool is_near(const Line& line, Point p, double reach) {
    if (to_side(line.around, p) < -reach) return false;
    const auto& points = line.stroke.points;
    const std::size_t sides = points.size() - (line.stroke.closed ? 0 : 1);
    for (std::size_t i = 0; i < sides; ++i)
        if (distance_to_segment(p, points[i], points[(i + 1) % points.size()]) <= reach) return true;
    return false;
}

}  // namespace

WholeLines whole_lines(const Drawing& drawing, double reach) {
    constexpr double kLong = 4;  // times the reach: a shorter line's ends are near each other without closing anything
    const std::vector<Line> lines = lines_in(drawing);
    Box frame = kNothing;
    WholeLines whole;
    whole.lines = lines.size();
    for (const Line& line : lines) {
        whole.length += line.length;
        for (const Point p : line.stroke.points) frame.take(p);
    }
    for (const Line& line : lines) {
        std::size_t loose = 0;
        if (!line.stroke.closed) {
            const Point first = line.stroke.points.front(), last = line.stroke.points.back();
            const bool closes = line.length > kLong * reach && distance(first, last) <= reach;
            for (const Point end : {first, last}) {
                const bool held = closes || to_side(frame, end) <= reach ||
                                  std::any_of(lines.begin(), lines.end(),
                                              [&](const Line& other) { return &other != &line && is_near(other, end, reach); });
                loose += held ? 0 : 1;
            }
        }
        whole.loose_ends += loose;
        if (loose == 0) whole.whole += line.length;
    }
    return whole;
}

}  // namespace tactics
