// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/growth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "tactics/solid/flattened.h"

namespace tactics {

namespace {

constexpr double kUpright = 0.7;   // cosine up to which something that leans is straightened, and beyond which it is laid down
constexpr double kAsLarge = 1e-3;  // of the scale, which the last digits of a file do not decide

// The area for panels: around all of them in place, extended by the length of the largest.
Box room_of(const Panels& panels, const ViewPlane& view) {
    Box all = kNothing;
    double longest = 0;
    for (const Panel& panel : panels.panels) {
        Box box = kNothing;
        for (const auto& ring : panel.rings)
            for (const Point3& at : ring) box.take({dot(at, view.right), dot(at, view.down)});
        if (panel.rings.empty()) continue;
        all.take({box.left, box.top});
        all.take({box.right, box.bottom});
        longest = std::max({longest, box.width(), box.height(), std::sqrt(panel.area)});
    }
    return grown(all, longest);
}

Box box_of(const PlacedBar& bar) { return tactics::box_of(std::array{bar.from, bar.to}); }

}  // namespace

struct Growth::State {
    FlatLayout layout;
    GrowingGrid panel_boxes, bar_boxes;       // of those of the layout
    std::vector<int> place;                   // of each panel in the layout; -1: not laid
    std::vector<std::size_t> laid, outlines;  // panels of each part, and those of them that are outlines
    double smallest = 0;                      // scale
    Box extent = kNothing;                    // of all of it
};

Growth::Growth(const std::vector<ModelPart>& parts, const Panels& panels, const std::vector<std::uint32_t>& thing,
               const ViewPlane& view, const LayoutWish& wish)
    : parts_(parts),
      panels_(panels),
      thing_(thing),
      view_(view),
      wish_(wish),
      worth_(parts, panels, view),
      hinges_(panels.panels.size()),
      has_kept_(parts.size(), 0),
      kept_boxes_(room_of(panels, view), panels.panels.size()),
      no_bars_(room_of(panels, view), panels.bars.size()) {
    touching_ = touching_in(parts);
    for (std::uint32_t i = 0; i < panels.hinges.size(); ++i) {
        hinges_[panels.hinges[i].one].push_back(i);
        hinges_[panels.hinges[i].other].push_back(i);
    }
    for (std::uint32_t i = 0; i < panels.panels.size(); ++i) {
        const Panel& panel = panels.panels[i];
        middles_.push_back(panel.rings.empty() ? Point3{} : middle_of(panel));
        if (dot(panel.normal, view.toward) < kAligned) continue;
        has_kept_[panel.part] = 1;
        if (panel.rings.empty()) continue;
        PlacedPanel placed{.panel = i, .height = dot(middles_[i], view.toward), .placement = {}, .shape = {}};
        placed.placement = {{}, view.right, view.down, {}, {1, 0}, {0, 1}};
        placed.shape = shape_of(i, placed.placement);
        kept_.push_back(std::move(placed));
    }
    drop_hidden();
    for (const PlacedPanel& one : kept_) kept_boxes_.add(one.shape.box);
}

// What others hide is not there for a hand.
void Growth::drop_hidden() {
    GrowingGrid boxes = kept_boxes_;
    for (const PlacedPanel& one : kept_) boxes.add(one.shape.box);
    std::vector<PlacedPanel> seen;
    for (const PlacedPanel& one : kept_) {
        const auto is_hidden = [&](Point at) {
            return boxes.any_near({at.x, at.y, at.x, at.y}, [&](std::size_t other) {
                return kept_[other].height > one.height + touching_ && holds(kept_[other].shape, at);
            });
        };
        bool visible = false;
        for (const auto& ring : one.shape.rings)
            for (std::size_t i = 0; i < ring.size() && !visible; ++i) {
                const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
                const double length = distance(a, b);
                if (!(length > 0)) continue;
                for (const double side : {2.0, -2.0}) {
                    const Point in{(a.x + b.x) / 2 - side * touching_ * (b.y - a.y) / length,
                                   (a.y + b.y) / 2 + side * touching_ * (b.x - a.x) / length};
                    if (holds(one.shape, in) && !is_hidden(in)) visible = true;
                }
            }
        if (visible) seen.push_back(one);
    }
    kept_ = std::move(seen);
}

double Growth::scale_of_kept() const {
    Box all = kNothing;
    for (const PlacedPanel& one : kept_) take(all, one.shape.box);
    return wish_.room.width > 0 && std::max(all.width(), all.height()) > touching_ ? scale_in(wish_.room, all) : 0;
}

bool Growth::has_room(const State& state, const Box& box) const {
    Box all = state.extent;
    take(all, box);
    return state.smallest == 0 || scale_in(wish_.room, all) >= (1 - kAsLarge) * state.smallest;
}

FlatLayout Growth::grown(Strategy strategy, const std::vector<double>& favour, double smallest) {
    State state{{kept_, {}, {}},
                kept_boxes_,
                no_bars_,
                std::vector<int>(panels_.panels.size(), -1),
                std::vector<std::size_t>(parts_.size(), 0),
                std::vector<std::size_t>(parts_.size(), 0),
                smallest};
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        count(state, kept_[i].panel, i);
        take(state.extent, kept_[i].shape.box);
    }
    grow(state, strategy, favour);
    take_rest(state);
    grow(state, strategy, favour);
    add_bars(state);
    return std::move(state.layout);
}

FlatShape Growth::shape_of(std::uint32_t panel, const Placement& placement) const {
    std::vector<std::vector<Point>> rings;
    for (const auto& ring : panels_.panels[panel].rings) {
        rings.emplace_back();
        for (const Point3& at : ring) rings.back().push_back(placement.of(at));
    }
    return flat_shape(std::move(rings));
}

void Growth::count(State& state, std::uint32_t panel, std::size_t place) const {
    state.place[panel] = static_cast<int>(place);
    ++state.laid[panels_.panels[panel].part];
    state.outlines[panels_.panels[panel].part] += is_view(panels_.panels[panel].kind);
}

void Growth::place(State& state, PlacedPanel placed) const {
    count(state, placed.panel, state.layout.panels.size());
    state.panel_boxes.add(placed.shape.box);
    take(state.extent, placed.shape.box);
    state.layout.panels.push_back(std::move(placed));
}

bool Growth::may_add(const State& state, std::uint32_t panel) const {
    const Panel& one = panels_.panels[panel];
    if (state.place[panel] >= 0 || !one.reached || one.rings.empty() || !parts_[one.part].folds) return false;
    if (one.kind == PanelKind::hanging) return state.laid[one.part] == 0;
    return !is_view(one.kind) || state.outlines[one.part] < most_outlines(parts_[one.part].form);
}

PlacedPanel Growth::folded(const State& state, const Hinge& hinge, bool other_way) const {
    const std::uint32_t parent = other_way ? hinge.other : hinge.one, child = other_way ? hinge.one : hinge.other;
    const PlacedPanel& onto = state.layout.panels[static_cast<std::size_t>(state.place[parent])];
    // As the parent goes round its border; the child comes the other way.
    const Point3 parent_from = other_way ? hinge.other_to : hinge.one_from,
                 parent_to = other_way ? hinge.other_from : hinge.one_to;
    const Point3 child_from = other_way ? hinge.one_to : hinge.other_from, child_to = other_way ? hinge.one_from : hinge.other_to;
    const Placement& there = onto.placement;
    const Point from = there.of(parent_from), to = there.of(parent_to);
    const double length = distance(from, to);
    PlacedPanel placed{.panel = child,
                       .handling = Handling::folded,
                       .folds = onto.folds + 1,
                       .height = onto.height,
                       .placement = {},
                       .shape = {}};
    if (!(length > 0)) return placed;
    const Point along{(to.x - from.x) / length, (to.y - from.y) / length};
    // The parent's inside is to the left, unless it is seen from behind.
    const double turned = dot(cross(there.along, there.across), panels_.panels[parent].normal) *
                          (there.to_along.x * there.to_across.y - there.to_along.y * there.to_across.x);
    const double side = turned > 0 ? 1 : -1;
    const Point3 edge = unit(child_to - child_from);
    Point3 across = unit(cross(edge, panels_.panels[child].normal));
    if (dot(across, middles_[child] - child_from) < 0) across = -1 * across;
    const Point away{side * along.y, -side * along.x};
    // Lines that meet at no angle would be one for a finger long before they meet.
    const double gap = hinge.is_tangent ? wish_.gap : 0;
    placed.placement = {child_from, edge, across, {from.x + gap * away.x, from.y + gap * away.y}, along, away};
    placed.shape = shape_of(child, placed.placement);
    return placed;
}

void Growth::grow(State& state, Strategy strategy, const std::vector<double>& favour) const {
    struct Next {
        double worth;  // of those that are worth the same the first in the list goes first
        std::uint32_t hinge;
        bool other_way;
        bool operator<(const Next& than) const { return worth != than.worth ? worth < than.worth : hinge > than.hinge; }
    };
    std::priority_queue<Next> waiting;
    const auto open = [&](std::uint32_t panel) {
        const int folds = state.layout.panels[static_cast<std::size_t>(state.place[panel])].folds;
        // A fold that costs the reader more than a face is worth is not made.
        if (wish_.reader.fold + folds * wish_.reader.fold_again >= 1) return;
        for (const std::uint32_t number : hinges_[panel]) {
            const Hinge& hinge = panels_.hinges[number];
            const bool other_way = hinge.other == panel;
            const std::uint32_t child = other_way ? hinge.one : hinge.other;
            if (may_add(state, child))
                waiting.push({favour[child] * worth_.of(strategy, number, child, folds), number, other_way});
        }
    };
    for (std::size_t i = 0; i < state.layout.panels.size(); ++i) open(state.layout.panels[i].panel);
    while (!waiting.empty()) {
        const Next next = waiting.top();
        waiting.pop();
        const Hinge& hinge = panels_.hinges[next.hinge];
        const std::uint32_t child = next.other_way ? hinge.one : hinge.other;
        if (!may_add(state, child)) continue;
        PlacedPanel placed = folded(state, hinge, next.other_way);
        const std::uint32_t parent = next.other_way ? hinge.other : hinge.one;
        const PlacedPanel& onto = state.layout.panels[static_cast<std::size_t>(state.place[parent])];
        if (placed.shape.rings.empty() || !is_free(state, placed, &onto)) continue;
        place(state, std::move(placed));
        open(child);
    }
}

bool Growth::is_free(const State& state, const PlacedPanel& placed, const PlacedPanel* onto) const {
    if (!has_room(state, placed.shape.box)) return false;
    const std::uint32_t part = panels_.panels[placed.panel].part;
    const auto is_in_its_way = [&](std::size_t number) {
        const PlacedPanel& other = state.layout.panels[number];
        const std::uint32_t others = panels_.panels[other.panel].part;
        const ShapeMeeting meeting = meeting_of(placed.shape, other.shape, touching_);
        if (meeting == ShapeMeeting::crossing || meeting == ShapeMeeting::round) return true;
        if (meeting == ShapeMeeting::inside &&
            (others == part || other.handling != Handling::kept || other.height > placed.height + touching_))
            return true;
        // Lines of different things are apart, or one line.
        if (thing_[others] == thing_[part]) return false;
        const double apart = distance(placed.shape, other.shape);
        if (apart >= wish_.gap || apart <= touching_) return false;
        // What stands near the border that it is folded about is as near to that in any case.
        return onto == nullptr || other.handling != Handling::kept ||
               meeting_of(other.shape, onto->shape, touching_) != ShapeMeeting::inside;
    };
    // Bars come last.
    return !state.panel_boxes.any_near(tactics::grown(placed.shape.box, wish_.gap), is_in_its_way);
}

void Growth::place(State& state, const PlacedBar& placed) const {
    state.bar_boxes.add(box_of(placed));
    take(state.extent, box_of(placed));
    state.layout.bars.push_back(placed);
}

PlacedPanel Growth::straightened(std::uint32_t number) const {
    const Panel& panel = panels_.panels[number];
    const Point3 middle = middles_[number], normal = panel.normal;
    const double away = dot(normal, view_.toward) < 0 ? -1 : 1;
    PlacedPanel placed{
        .panel = number, .handling = Handling::straightened, .height = dot(middle, view_.toward), .placement = {}, .shape = {}};
    Point3 along = view_.right - dot(view_.right, normal) * normal;
    if (length_of(along) < 0.1) along = dot(view_.down, normal) * normal - view_.down;
    along = unit(along);
    // A footprint is seen through what stands on it.
    placed.placement = {middle, along, away * cross(along, normal), {dot(middle, view_.right), dot(middle, view_.down)},
                        {1, 0}, {0, 1}};
    if (std::abs(dot(normal, view_.toward)) >= kAligned) placed.handling = Handling::kept;
    placed.shape = shape_of(number, placed.placement);
    return placed;
}

PlacedPanel Growth::laid(std::uint32_t number) const {
    const Panel& panel = panels_.panels[number];
    PlacedPanel placed{.panel = number, .handling = Handling::lying, .folds = 1, .height = 0, .placement = {}, .shape = {}};
    // About the lowest of its sides that lie in the plane; without one about its lowest corner.
    Point3 foot = panel.rings.front().front();
    for (const Point3& corner : panel.rings.front())
        if (dot(corner, view_.toward) < dot(foot, view_.toward) - touching_) foot = corner;
    const Point3 along = unit(cross(view_.toward, panel.normal));
    Point3 across = cross(panel.normal, along);
    if (dot(across, view_.toward) < 0) across = -1 * across;
    const Point flat{dot(along, view_.right), dot(along, view_.down)};
    const Point out{dot(panel.normal, view_.right), dot(panel.normal, view_.down)};
    const double length = std::max(1e-12, std::hypot(out.x, out.y));
    // It falls onto its back, so that its front is up.
    placed.placement = {
        foot, along, across, {dot(foot, view_.right), dot(foot, view_.down)}, flat, {-out.x / length, -out.y / length}};
    placed.height = dot(foot, view_.toward);
    placed.shape = shape_of(number, placed.placement);
    return placed;
}

void Growth::take_rest(State& state) const {
    std::vector<std::uint32_t> best(parts_.size(), ~0u);
    for (std::uint32_t i = 0; i < panels_.panels.size(); ++i) {
        const Panel& panel = panels_.panels[i];
        if (state.laid[panel.part] != 0 || panel.rings.empty() || panel.kind == PanelKind::hanging) continue;
        // The side that looks most towards the reader, or else straight away from him.
        const auto worth = [&](const Panel& one) {
            const double toward = dot(one.normal, view_.toward);
            return toward <= -kAligned  ? 0.9
                   : toward >= kUpright ? toward
                                        : -1 + 1e-3 * std::sqrt(one.area) / (1 + std::sqrt(one.area));
        };
        if (best[panel.part] == ~0u || worth(panel) > worth(panels_.panels[best[panel.part]]) + 1e-4) best[panel.part] = i;
    }
    for (std::uint32_t part = 0; part < parts_.size(); ++part) {
        if (best[part] == ~0u || state.place[best[part]] >= 0) continue;
        const Panel& panel = panels_.panels[best[part]];
        // Something of this part may be hidden under others, and then stays so.
        if (has_kept_[part] != 0) continue;
        const double toward = std::abs(dot(panel.normal, view_.toward));
        PlacedPanel placed = toward >= kUpright ? straightened(best[part]) : laid(best[part]);
        if (is_free(state, placed)) place(state, std::move(placed));
    }
}

bool Growth::is_free(const State& state, const PlacedBar& bar, std::uint32_t holder) const {
    if (!has_room(state, box_of(bar))) return false;
    const double apart = std::max(wish_.gap, touching_);
    const auto is_in_its_way = [&](std::size_t number) {
        const PlacedPanel& other = state.layout.panels[number];
        const ShapeMeeting meeting = meeting_of(bar.from, bar.to, other.shape, touching_);
        if (meeting == ShapeMeeting::crossing) return true;
        if (other.panel == holder) return false;
        // Nor does it run along the border of something else.
        const Point middle{(bar.from.x + bar.to.x) / 2, (bar.from.y + bar.to.y) / 2};
        if (distance_to_border(other.shape, middle) < apart || distance_to_border(other.shape, bar.to) < apart) return true;
        return meeting == ShapeMeeting::inside && (other.handling != Handling::kept || other.height > bar.height + touching_);
    };
    if (state.panel_boxes.any_near(tactics::grown(box_of(bar), apart), is_in_its_way)) return false;
    return !state.bar_boxes.any_near(box_of(bar), [&](std::size_t number) {
        const PlacedBar& other = state.layout.bars[number];
        return other.handling != Handling::wedge && cross(bar.from, bar.to, other.from, other.to, touching_);
    });
}

bool Growth::lies_on_what_is_kept(const State& state, const PlacedBar& bar) const {
    return !state.panel_boxes.any_near(box_of(bar), [&](std::size_t number) {
        const PlacedPanel& other = state.layout.panels[number];
        return other.handling != Handling::kept && meeting_of(bar.from, bar.to, other.shape, touching_) != ShapeMeeting::apart;
    });
}

void Growth::add_bars(State& state) const {
    for (std::uint32_t number = 0; number < panels_.bars.size(); ++number) {
        const Bar& bar = panels_.bars[number];
        const Point3 along = bar.loose - bar.held;
        const double length = length_of(along);
        PlacedBar placed{
            .bar = number, .height = std::max(dot(bar.held, view_.toward), dot(bar.loose, view_.toward)), .from = {}, .to = {}};
        placed.from = {dot(bar.held, view_.right), dot(bar.held, view_.down)};
        placed.to = {dot(bar.loose, view_.right), dot(bar.loose, view_.down)};
        if (bar.is_edge) {
            if (state.laid[bar.part] == 0 && lies_on_what_is_kept(state, placed)) place(state, placed);
            continue;
        }
        if (std::abs(dot(along, view_.toward)) <= kLevel * length) {
            place(state, placed);
            continue;
        }
        bool done = false;
        if (parts_[bar.part].folds && bar.ends_held == 1 && state.place[bar.holder] >= 0) {
            const PlacedPanel& holder = state.layout.panels[static_cast<std::size_t>(state.place[bar.holder])];
            const Point3& normal = panels_.panels[bar.holder].normal;
            const Point3 on = bar.held - dot(normal, bar.held - panels_.panels[bar.holder].rings.front().front()) * normal;
            placed.handling = Handling::flattened;
            for (const FlatBar& way : ways_to_flatten(holder.shape, holder.placement.of(on), length)) {
                placed.from = way.from;
                placed.to = way.to;
                if (!is_free(state, placed, bar.holder)) continue;
                place(state, placed);
                done = true;
                break;
            }
        }
        if (done) continue;
        placed.handling = Handling::wedge;
        placed.from = placed.to = {dot(bar.held, view_.right), dot(bar.held, view_.down)};
        place(state, placed);
    }
}

}  // namespace tactics
