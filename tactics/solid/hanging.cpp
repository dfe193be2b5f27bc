// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/hanging.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/solid/outline.h"
#include "tactics/solid/space_box.h"

namespace tactics {

namespace {

constexpr double kOtherWay = 0.9;         // cosine of two directions that are as good as one
constexpr std::size_t kMostCorners = 12;  // of a face; with more it is round
constexpr double kBeside = 0.1;   // share of the width of a round face: a thing farther from its middle has its own direction
constexpr double kAsNear = 0.01;  // of the width of a face, which two of its sides may differ by and be as near
constexpr std::size_t kMostHanging = 256;   // more could not be felt, and each needs a side view
constexpr std::size_t kMostDirections = 4;  // one has to have room

// A side of a face, and how far from it something is.
struct NearSide {
    Point3 from, way, out;  // lengths of `way` and `out` 1
    double length = 0, off = 0;
};

std::vector<NearSide> straight_sides(const Panel& face, const Point3& at, const ViewPlane& view) {
    std::vector<NearSide> sides;
    const auto& ring = face.rings.front();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point3 side = ring[(i + 1) % ring.size()] - ring[i];
        const double length = length_of(side);
        if (!(length > 0)) continue;
        const Point3 way = unit(side);
        const Point3 gap = at - (ring[i] + std::clamp(dot(at - ring[i], way), 0.0, length) * way);
        sides.push_back({ring[i], way, cross(way, face.normal), length, length_of(gap - dot(gap, face.normal) * face.normal)});
    }
    // Of those as near as each other the one towards the reader.
    const double grain = kAsNear * std::sqrt(face.area);
    const auto order = [&](const NearSide& side) { return std::pair(std::llround(side.off / grain), -dot(side.out, view.down)); };
    std::stable_sort(sides.begin(), sides.end(), [&](const NearSide& a, const NearSide& b) { return order(a) < order(b); });
    return sides;
}

// Something round has no sides: away from its middle, or else towards the reader, to the right, to the left and away from him.
std::vector<NearSide> ways_off_a_curve(const Panel& face, const Point3& at, const ViewPlane& view) {
    const auto& ring = face.rings.front();
    const Point3 off = at - middle_of(face), aside = off - dot(off, face.normal) * face.normal;
    std::vector<Point3> directions = {view.down, view.right, -1 * view.right, -1 * view.down};
    if (length_of(aside) > kBeside * std::sqrt(face.area)) directions.insert(directions.begin(), unit(aside));
    std::vector<NearSide> sides;
    for (const Point3& out : directions) {
        const Point3& last = *std::max_element(ring.begin(), ring.end(),
                                               [&](const Point3& a, const Point3& b) { return dot(a, out) < dot(b, out); });
        const Point3 way = cross(face.normal, out);
        // The point where the direction from the middle meets the border, on its tangent.
        sides.push_back({last + dot(middle_of(face) - last, way) * way, way, out, 0, 0});
    }
    return sides;
}

// The nearest first, none twice.
std::vector<NearSide> sides_near(const Panel& face, const Point3& at, const ViewPlane& view) {
    std::vector<NearSide> apart;
    for (const NearSide& side :
         face.rings.front().size() > kMostCorners ? ways_off_a_curve(face, at, view) : straight_sides(face, at, view)) {
        if (apart.size() == kMostDirections) break;
        if (std::none_of(apart.begin(), apart.end(), [&](const NearSide& one) { return dot(one.out, side.out) > kOtherWay; }))
            apart.push_back(side);
    }
    return apart;
}

class Hanging {
public:
    Hanging(Panels& panels, const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing, const SpaceGrid& near,
            const ViewPlane& view)
        : panels_(panels), parts_(parts), thing_(thing), near_(near), view_(view) {
        most_ = panels.panels.size() + kMostHanging;
        for (const ModelPart& part : parts) depth_.push_back(stretch_of(part.solid, view.toward));
    }

    void hang_on(std::uint32_t face) {
        if (is_covered(face)) return;
        for (const std::uint32_t part : parts_near(panels_.panels[face].part))
            if (hangs_on(part, face))
                for (const NearSide& side : sides_near(panels_.panels[face], parts_[part].box.middle, view_))
                    if (panels_.panels.size() < most_) hang(part, face, side);
    }

private:
    bool is_thick(std::uint32_t part) const { return parts_[part].form != PartForm::line && parts_[part].form != PartForm::face; }
    std::vector<std::uint32_t> parts_near(std::uint32_t part) const {
        return near_.near(grown(space_of(parts_[part]), kLoose * parts_[part].box.half[0]));
    }
    double slack(std::uint32_t a, std::uint32_t b) const {
        return kLoose * std::min(parts_[a].box.half[0], parts_[b].box.half[0]);
    }

    bool is_under(std::uint32_t part, const Panel& face) const {
        const Point3& middle = parts_[part].box.middle;
        const double off = dot(face.normal, middle - face.rings.front().front());
        return part != face.part && thing_[part] == thing_[face.part] && off < 0 &&
               is_over(middle - off * face.normal, face.normal, face.rings);
    }

    // Something stands on all of it.
    bool is_covered(std::uint32_t number) const {
        const Panel face = panels_.panels[number];
        const std::vector<std::uint32_t> near = parts_near(face.part);
        return std::any_of(near.begin(), near.end(), [&](std::uint32_t part) {
            if (part == face.part || depth_[part].high <= depth_[face.part].high + slack(part, face.part)) return false;
            const SpaceBox box = grown(space_of(parts_[part]), slack(part, face.part));
            return std::all_of(face.rings.front().begin(), face.rings.front().end(), [&](const Point3& at) {
                return at.x >= box.low.x && at.x <= box.high.x && at.y >= box.low.y && at.y <= box.high.y && at.z >= box.low.z &&
                       at.z <= box.high.z;
            });
        });
    }

    bool hangs_on(std::uint32_t part, std::uint32_t number) const {
        const Panel& face = panels_.panels[number];
        if (!is_thick(part) || !is_under(part, face)) return false;
        return apart(space_of(parts_[part]), space_of(parts_[face.part])) <= slack(part, face.part) &&
               depth_[part].high <= depth_[face.part].high + slack(part, face.part);
    }

    std::uint32_t add_outline(std::uint32_t part, const NearSide& side) {
        OutlineOfPart outline = outline_of(parts_[part].solid, side.out, side.way, view_.toward);
        panels_.panels.push_back({part, PanelKind::hanging, side.out, std::move(outline.rings), outline.area});
        return static_cast<std::uint32_t>(panels_.panels.size() - 1);
    }

    // The upper edge of what a part looks like from there.
    Hinge hinge(std::uint32_t part, std::uint32_t one, std::uint32_t other, const Point3& out, const Point3& way) const {
        const Stretch wide = stretch_of(parts_[part].solid, way);
        const Point3 head = stretch_of(parts_[part].solid, out).high * out + depth_[part].high * view_.toward;
        const Point3 from = wide.low * way + head, to = wide.high * way + head;
        return {one, other, from, to, from, to};
    }

    void hang(std::uint32_t part, std::uint32_t face, const NearSide& side) {
        const std::uint32_t outline = add_outline(part, side);
        Hinge made = hinge(part, face, outline, side.out, side.way);
        // On the border, beside where the part stands.
        const Stretch wide = stretch_of(parts_[part].solid, side.way);
        const double width = wide.high - wide.low;
        double begin = wide.low - dot(side.from, side.way);
        if (width <= side.length)
            begin = std::clamp(begin, 0.0, side.length - width);
        else
            begin = std::clamp(begin + width / 2, 0.0, side.length) - width / 2;
        made.one_from = side.from + begin * side.way;
        made.one_to = made.one_from + width * side.way;
        panels_.hinges.push_back(made);
        std::vector<std::uint32_t> hung = {part};
        hang_below(hung, outline, face, side);
    }

    // A foot, or what else the last of `hung` bears below; each hangs once.
    void hang_below(std::vector<std::uint32_t>& hung, std::uint32_t outline, std::uint32_t face, const NearSide& side) {
        const std::uint32_t holder = hung.back();
        for (const std::uint32_t part : parts_near(holder)) {
            if (std::find(hung.begin(), hung.end(), part) != hung.end() || parts_[part].form == PartForm::line ||
                !is_under(part, panels_.panels[face]))
                continue;
            if (apart(space_of(parts_[part]), space_of(parts_[holder])) > slack(part, holder)) continue;
            if (depth_[part].high > depth_[holder].low + slack(part, holder)) continue;
            if (panels_.panels.size() >= most_) return;
            const std::uint32_t below = add_outline(part, side);
            panels_.hinges.push_back(hinge(part, outline, below, side.out, side.way));
            hung.push_back(part);
            hang_below(hung, below, face, side);
        }
    }

    Panels& panels_;
    const std::vector<ModelPart>& parts_;
    const std::vector<std::uint32_t>& thing_;
    const SpaceGrid& near_;
    const ViewPlane& view_;
    std::size_t most_ = 0;        // panels, with those that hang
    std::vector<Stretch> depth_;  // of each part, towards the reader
};

}  // namespace

void add_hanging(Panels& panels, const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing,
                 const SpaceGrid& near, const ViewPlane& view) {
    Hanging hanging(panels, parts, thing, near, view);
    const auto faces = static_cast<std::uint32_t>(panels.panels.size());
    for (std::uint32_t face = 0; face < faces; ++face) {
        const Panel& one = panels.panels[face];
        if (!is_view(one.kind) && one.kind != PanelKind::bottom && !one.rings.empty() && dot(one.normal, view.toward) >= kAligned)
            hanging.hang_on(face);
    }
}

}  // namespace tactics
