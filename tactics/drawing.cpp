// SPDX-License-Identifier: Apache-2.0
#include "tactics/drawing.h"

#include <array>

namespace tactics {

namespace {

constexpr std::array<std::string_view, 12> kRoles{"line", "lead", "tick",  "dash",    "arrow", "symbol",
                                                  "axis", "grid", "scale", "pattern", "mark",  "dots"};

}  // namespace

std::string_view name_of(Role role) { return kRoles[static_cast<std::size_t>(role)]; }

Role role_named(std::string_view name) {
    for (std::size_t i = 0; i < kRoles.size(); ++i)
        if (kRoles[i] == name) return static_cast<Role>(i);
    return Role::line;
}

Drawing scaled_to(Drawing drawing, double width) {
    const double scale = width / drawing.width;
    if (scale == 1) return drawing;
    const auto move = [scale](Point& p) { p = {p.x * scale, p.y * scale}; };
    for (Stroke& stroke : drawing.strokes)
        for (Point& p : stroke.points) move(p);
    for (Area& area : drawing.areas)
        for (auto& ring : area.rings)
            for (Point& p : ring) move(p);
    for (Label& label : drawing.labels) move(label.at);
    for (Name& name : drawing.names) move(name.at);
    for (Region& region : drawing.regions) {
        move(region.at);
        for (auto& ring : region.rings)
            for (Point& p : ring) move(p);
    }
    drawing.width = width;
    drawing.height *= scale;
    return drawing;
}

// How often the rings go round the place, which they do otherwise than 0 times if it is within.
bool holds(const Region& region, Point at) {
    int times = 0;
    for (const auto& ring : region.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.y > at.y) == (b.y > at.y)) continue;
            if (at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) times += b.y > a.y ? 1 : -1;
        }
    return times != 0;
}

double length_of(const Stroke& stroke) {
    double length = 0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i) length += distance(stroke.points[i - 1], stroke.points[i]);
    if (stroke.closed && !stroke.points.empty()) length += distance(stroke.points.back(), stroke.points.front());
    return length;
}

double total_stroke_length(const Drawing& drawing) {
    double length = 0;
    for (const auto& stroke : drawing.strokes) length += length_of(stroke);
    return length;
}

}  // namespace tactics
