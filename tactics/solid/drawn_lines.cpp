// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/drawn_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/solid/close_sides.h"
#include "tactics/solid/joined_sides.h"
#include "tactics/solid/near_borders.h"
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
    explicit Over(std::size_t panels) : drowns(panels, 0) {}
    std::vector<const PlacedPanel*> hiding;
    std::vector<char> drowns;  // by the places in the layout
};

class SidesUnder {
public:
    SidesUnder(const FlatLayout& layout, double touching, double as_one)
        : layout_(layout), near_(layout, as_one), touching_(touching), as_one_(as_one) {}

    // The parts of a side that are not under any of these, nor so close to their borders that both would feel like one line.
    void take_visible(std::vector<DrawnSide>& sides, const DrawnSide& side, const Over& over) const {
        const double length = distance(side.from, side.to);
        if (!(length > touching_)) return;
        const std::vector<double> cuts = cuts_of(side, over);
        double begin = -1;
        std::size_t drowned_by = layout_.panels.size();  // the stretch before, and often the next one, too
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const Point from = at(side, cuts[i]), middle = at(side, (cuts[i] + cuts[i + 1]) / 2), to = at(side, cuts[i + 1]);
            const auto drowns = [&](std::size_t number) {
                const auto is_near = [&](Point place) {
                    return distance_to_border(layout_.panels[number].shape, place) < as_one_;
                };
                if (over.drowns[number] == 0 || !is_near(middle) || !is_near(from) || !is_near(to)) return false;
                drowned_by = number;
                return true;
            };
            const bool hidden = (drowned_by < layout_.panels.size() && drowns(drowned_by)) || is_under(over.hiding, middle) ||
                                near_.any_near(middle, drowns);
            if (!hidden && begin < 0) begin = cuts[i];
            if ((hidden || i + 2 == cuts.size()) && begin >= 0) {
                const double end = hidden ? cuts[i] : 1;
                if ((end - begin) * length > touching_) sides.push_back({at(side, begin), at(side, end), side.line, side.twice});
                begin = -1;
            }
        }
    }

private:
    static Point at(const DrawnSide& side, double share) {
        return {side.from.x + share * (side.to.x - side.from.x), side.from.y + share * (side.to.y - side.from.y)};
    }

    bool is_under(const std::vector<const PlacedPanel*>& hiding, Point place) const {
        return std::any_of(hiding.begin(), hiding.end(), [&](const PlacedPanel* one) {
            return one->shape.box.holds(place) && holds(one->shape, place) && distance_to_border(one->shape, place) > touching_;
        });
    }

    // Shares of a side where something may begin or end; a border that drowns it comes near, or crosses it.
    std::vector<double> cuts_of(const DrawnSide& side, const Over& over) const {
        const double length = distance(side.from, side.to);
        const double dx = side.to.x - side.from.x, dy = side.to.y - side.from.y;
        std::vector<double> cuts = {0, 1};
        for (std::size_t number = 0; number < layout_.panels.size(); ++number) {
            if (over.drowns[number] == 0) continue;
            for (const auto& ring : layout_.panels[number].shape.rings)
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
                    // Where a corner comes near and goes away again.
                    const double foot = ((a.x - side.from.x) * dx + (a.y - side.from.y) * dy) / (length * length);
                    if (foot > 0 && foot < 1 && distance(a, at(side, foot)) < as_one_) cuts.push_back(foot);
                    const double ex = b.x - a.x, ey = b.y - a.y, both = dx * ey - dy * ex;
                    if (std::abs(both) < 1e-12 * length * std::hypot(ex, ey)) continue;
                    const double t = ((a.x - side.from.x) * ey - (a.y - side.from.y) * ex) / both;
                    const double s = ((a.x - side.from.x) * dy - (a.y - side.from.y) * dx) / both;
                    if (t > 0 && t < 1 && s >= 0 && s <= 1) cuts.push_back(t);
                }
        }
        std::sort(cuts.begin(), cuts.end());
        return cuts;
    }

    const FlatLayout& layout_;
    NearBorders near_;
    double touching_, as_one_;
};

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
    const auto number_of = [&](const PlacedPanel& one) { return static_cast<std::size_t>(&one - layout.panels.data()); };
    const SidesUnder under(layout, touching, as_one);
    std::size_t inner = 0;
    for (const PlacedPanel& placed : layout.panels) {
        Over over(layout.panels.size());
        if (placed.handling == Handling::kept)
            for (const PlacedPanel& other : layout.panels) {
                if (other.handling != Handling::kept || !boxes_meet(other.shape, placed.shape, as_one)) continue;
                // Of two at the same height the first drowns the other.
                const bool is_higher = other.height > placed.height + touching;
                if (is_higher) over.hiding.push_back(&other);
                if (is_higher || (&other < &placed && other.height > placed.height - touching)) over.drowns[number_of(other)] = 1;
            }
        const Panel& panel = panels.panels[placed.panel];
        const LineClass line = level[panel.part] > 0 ? LineClass::thick : LineClass::normal;
        for (const LaidLine& own : own_lines(panel, placed, touching, apart, inner))
            for (std::size_t i = 0; i + (own.closed ? 0 : 1) < own.points.size(); ++i)
                under.take_visible(sides, {own.points[i], own.points[(i + 1) % own.points.size()], line}, over);
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
                under.take_visible(sides, {placed.shape.rings[r][i], placed.shape.rings[r][next], line, again}, over);
            }
    }
    for (const PlacedBar& bar : layout.bars) {
        if (bar.handling == Handling::wedge || distance(bar.from, bar.to) <= touching) continue;
        Over over(layout.panels.size());
        if (bar.handling == Handling::kept)
            for (const PlacedPanel& other : layout.panels)
                if (other.handling == Handling::kept && other.height > bar.height + touching) {
                    over.hiding.push_back(&other);
                    over.drowns[number_of(other)] = 1;
                }
        under.take_visible(sides, {bar.from, bar.to, LineClass::normal, false}, over);
    }
    sides = merged(sides, touching);
    const std::size_t united = unite_close(sides, touching, apart);
    return {joined(sides, touching), united + inner};
}

}  // namespace tactics
