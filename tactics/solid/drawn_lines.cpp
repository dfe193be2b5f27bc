// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/drawn_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/solid/close_sides.h"
#include "tactics/solid/joined_sides.h"
#include "tactics/solid/shown_twice.h"
#include "tactics/solid/thin_walls.h"

namespace tactics {

namespace {

// How many things lie one on the other below each.
std::vector<int> levels_of(const FlatLayout& layout, const Panels& panels, const std::vector<std::uint32_t>& thing,
                           double touching) {
    std::vector<int> level(thing.size(), 0);
    std::vector<const PlacedPanel*> kept;
    for (const PlacedPanel& placed : layout.panels)
        if (placed.handling == Handling::kept) kept.push_back(&placed);
    std::stable_sort(kept.begin(), kept.end(), [](const PlacedPanel* a, const PlacedPanel* b) { return a->height < b->height; });
    for (const PlacedPanel* over : kept)
        for (const PlacedPanel* under : kept) {
            const std::uint32_t top = panels.panels[over->panel].part, below = panels.panels[under->panel].part;
            if (top == below || under->height > over->height - touching || !boxes_meet(over->shape, under->shape, 0)) continue;
            if (meeting_of(over->shape, under->shape, touching) == ShapeMeeting::inside)
                level[top] = std::max(level[top], level[below] + 1);
        }
    return level;
}

// Panels over a side: those that hide it, and those whose border is so close that the side could not be felt separately.
struct Over {
    std::vector<const PlacedPanel*> hiding, drowning;
};

// The parts of a side that are not under any of these, nor so close to their borders that both would feel like one line.
void take_visible(std::vector<DrawnSide>& sides, const DrawnSide& side, const Over& over, double touching, double as_one) {
    const double length = distance(side.from, side.to);
    if (!(length > touching)) return;
    std::vector<double> cuts = {0, 1};
    const auto at = [&](double share) {
        return Point{side.from.x + share * (side.to.x - side.from.x), side.from.y + share * (side.to.y - side.from.y)};
    };
    for (const PlacedPanel* one : over.drowning)
        for (const auto& ring : one->shape.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
                // Where a corner comes near and goes away again.
                const double foot =
                    ((a.x - side.from.x) * (side.to.x - side.from.x) + (a.y - side.from.y) * (side.to.y - side.from.y)) /
                    (length * length);
                if (foot > 0 && foot < 1 && distance(a, at(foot)) < as_one) cuts.push_back(foot);
                const double dx = side.to.x - side.from.x, dy = side.to.y - side.from.y, ex = b.x - a.x, ey = b.y - a.y;
                const double both = dx * ey - dy * ex;
                if (std::abs(both) < 1e-12 * length * std::hypot(ex, ey)) continue;
                const double t = ((a.x - side.from.x) * ey - (a.y - side.from.y) * ex) / both;
                const double s = ((a.x - side.from.x) * dy - (a.y - side.from.y) * dx) / both;
                if (t > 0 && t < 1 && s >= 0 && s <= 1) cuts.push_back(t);
            }
    std::sort(cuts.begin(), cuts.end());
    double begin = -1;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Point middle = at((cuts[i] + cuts[i + 1]) / 2);
        const auto drowns = [&](const PlacedPanel* one) {
            const auto is_near = [&](Point place) { return distance_to_border(one->shape, place) < as_one; };
            return is_near(middle) && is_near(at(cuts[i])) && is_near(at(cuts[i + 1]));
        };
        const bool hidden = std::any_of(over.hiding.begin(), over.hiding.end(),
                                        [&](const PlacedPanel* one) {
                                            return holds(one->shape, middle) && distance_to_border(one->shape, middle) > touching;
                                        }) ||
                            std::any_of(over.drowning.begin(), over.drowning.end(), drowns);
        if (!hidden && begin < 0) begin = cuts[i];
        if ((hidden || i + 2 == cuts.size()) && begin >= 0) {
            const double end = hidden ? cuts[i] : 1;
            if ((end - begin) * length > touching) sides.push_back({at(begin), at(end), side.line, side.twice});
            begin = -1;
        }
    }
}

// Those on a panel that are no border of it, without the inner sides of thin walls, which are counted.
std::vector<LaidLine> own_lines(const Panel& panel, const PlacedPanel& placed, double touching, double apart,
                                std::size_t& inner) {
    std::vector<LaidLine> lines;
    for (const PanelLine& own : panel.lines) {
        LaidLine& line = lines.emplace_back();
        line.closed = own.closed;
        for (const Point3& at : own.points) line.points.push_back(placed.placement.of(at));
    }
    // A border is drawn, too; without one, the lines that lie on it are the outer ones.
    const std::size_t count = lines.size();
    if (panel.is_bordered)
        for (const auto& ring : placed.shape.rings) lines.push_back({ring, true});
    if (count > 0) inner += leave_out_inner(lines, placed.shape.rings, touching, apart);
    if (panel.is_bordered) lines.resize(lines.size() - placed.shape.rings.size());
    return lines;
}

}  // namespace

DrawnLines lines_of(const FlatLayout& layout, const std::vector<ModelPart>& parts, const Panels& panels,
                    const std::vector<std::uint32_t>& thing, double as_one, double apart) {
    const double touching = touching_in(parts);
    const std::vector<int> level = levels_of(layout, panels, thing, touching);
    // Panels that are hinged elsewhere than they lie together show that side twice.
    std::vector<std::vector<std::array<Point3, 2>>> twice(panels.panels.size());
    for (const std::uint32_t place : shown_twice(layout, panels, touching)) {
        const Hinge& hinge = panels.hinges[place];
        twice[hinge.one].push_back({hinge.one_from, hinge.one_to});
        twice[hinge.other].push_back({hinge.other_from, hinge.other_to});
    }
    std::vector<DrawnSide> sides;
    std::size_t inner = 0;
    for (const PlacedPanel& placed : layout.panels) {
        Over over;
        if (placed.handling == Handling::kept)
            for (const PlacedPanel& other : layout.panels) {
                if (other.handling != Handling::kept || !boxes_meet(other.shape, placed.shape, as_one)) continue;
                // Of two at the same height the first drowns the other.
                const bool is_higher = other.height > placed.height + touching;
                if (is_higher) over.hiding.push_back(&other);
                if (is_higher || (&other < &placed && other.height > placed.height - touching)) over.drowning.push_back(&other);
            }
        const Panel& panel = panels.panels[placed.panel];
        const LineClass line = level[panel.part] > 0 ? LineClass::thick : LineClass::normal;
        for (const LaidLine& own : own_lines(panel, placed, touching, apart, inner))
            for (std::size_t i = 0; i + (own.closed ? 0 : 1) < own.points.size(); ++i)
                take_visible(sides, {own.points[i], own.points[(i + 1) % own.points.size()], line}, over, touching, as_one);
        for (std::size_t r = 0; r < panel.rings.size() && panel.is_bordered; ++r)
            for (std::size_t i = 0; i < panel.rings[r].size(); ++i) {
                if (r == 0 && std::find(panel.open_sides.begin(), panel.open_sides.end(), i) != panel.open_sides.end()) continue;
                const std::size_t next = (i + 1) % panel.rings[r].size();
                const Point3 &a = panel.rings[r][i], &b = panel.rings[r][next];
                const bool again =
                    panel.kind == PanelKind::bottom ||
                    std::any_of(twice[placed.panel].begin(), twice[placed.panel].end(), [&](const auto& seam) {
                        const auto same = [&](const Point3& p, const Point3& q) { return length_of(p - q) <= 20 * touching; };
                        return (same(a, seam[0]) && same(b, seam[1])) || (same(a, seam[1]) && same(b, seam[0]));
                    });
                take_visible(sides, {placed.shape.rings[r][i], placed.shape.rings[r][next], line, again}, over, touching, as_one);
            }
    }
    std::vector<DrawnSide> bars;
    for (const PlacedBar& bar : layout.bars) {
        if (bar.handling == Handling::wedge || distance(bar.from, bar.to) <= touching) continue;
        Over over;
        if (bar.handling == Handling::kept)
            for (const PlacedPanel& other : layout.panels)
                if (other.handling == Handling::kept && other.height > bar.height + touching) over.hiding.push_back(&other);
        over.drowning = over.hiding;
        take_visible(sides, {bar.from, bar.to, LineClass::normal, false}, over, touching, as_one);
    }
    sides = merged(sides, touching);
    const std::size_t united = unite_close(sides, touching, apart);
    return {joined(sides, touching), united + inner};
}

}  // namespace tactics
