// SPDX-License-Identifier: Apache-2.0
// A layout that grows panel by panel from those that lie in the plane already.
#pragma once

#include <vector>

#include "tactics/geometry/growing_grid.h"
#include "tactics/solid/fold_worth.h"
#include "tactics/solid/layout.h"

namespace tactics {

class Growth {
public:
    /// All must outlive it.
    Growth(const std::vector<ModelPart>& parts, const Panels& panels, const std::vector<std::uint32_t>& thing,
           const ViewPlane& view, const LayoutWish& wish);
    /// `favour`: of each panel, by which its turn comes sooner. `smallest`: nothing is folded out that would make the scale in
    /// the room smaller than that; 0: it may.
    FlatLayout grown(Strategy strategy, const std::vector<double>& favour, double smallest = 0);
    /// Of what lies where it is, without all else; 0: of nothing, or in no room.
    double scale_of_kept() const;

private:
    struct State;
    void drop_hidden();
    void grow(State& state, Strategy strategy, const std::vector<double>& favour) const;
    void take_rest(State& state) const;
    void add_bars(State& state) const;
    void count(State& state, std::uint32_t panel, std::size_t place) const;
    void place(State& state, PlacedPanel placed) const;
    void place(State& state, const PlacedBar& placed) const;
    bool has_room(const State& state, const Box& box) const;
    /// `onto`: what it is folded out of; nothing: of nothing.
    bool is_free(const State& state, const PlacedPanel& placed, const PlacedPanel* onto = nullptr) const;
    bool is_free(const State& state, const PlacedBar& bar, std::uint32_t holder) const;
    bool lies_on_what_is_kept(const State& state, const PlacedBar& bar) const;
    bool may_add(const State& state, std::uint32_t panel) const;
    PlacedPanel folded(const State& state, const Hinge& hinge, bool other_way) const;
    PlacedPanel straightened(std::uint32_t panel) const;
    PlacedPanel laid(std::uint32_t panel) const;
    FlatShape shape_of(std::uint32_t panel, const Placement& placement) const;

    const std::vector<ModelPart>& parts_;
    const Panels& panels_;
    const std::vector<std::uint32_t>& thing_;
    ViewPlane view_;
    LayoutWish wish_;
    FoldWorth worth_;
    double touching_ = 0;                             // mm
    std::vector<std::vector<std::uint32_t>> hinges_;  // of each panel
    std::vector<Point3> middles_;                     // of each panel
    std::vector<char> has_kept_;                      // of each part: a side of it is parallel to the plane
    std::vector<PlacedPanel> kept_;                   // the same in every layout
    GrowingGrid kept_boxes_;                          // of those
    GrowingGrid no_bars_;                             // with room for all
};

}  // namespace tactics
