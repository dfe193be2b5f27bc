// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/panels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tactics/solid/hanging.h"
#include "tactics/solid/outline.h"
#include "tactics/solid/round_panels.h"
#include "tactics/solid/space_grid.h"

namespace tactics {

namespace {

constexpr double kParallel = 0.02;  // sine of the angle below which two sides run alike
constexpr double kCommon = 0.3;     // of the shorter side that two sides have in
                                    // common where they hang together

using Ring = std::vector<Point3>;

double thickness(const ModelPart& part) { return 2 * part.box.half[2]; }

// The allowed distance of two parts where they meet: each lies on its own middle, or on one of its sides.
double slack(const ModelPart& a, const ModelPart& b) {
    return thickness(a) * (a.form == PartForm::face) + thickness(b) * (b.form == PartForm::face) +
           kLoose * std::min(a.box.half[0], b.box.half[0]);
}

void add_panel(Panels& made, std::uint32_t part, PanelKind kind, const Point3& normal, std::vector<Ring> rings, double area) {
    made.panels.push_back({part, kind, normal, std::move(rings), area});
}

void add_sides(Panels& made, const ModelPart& part, std::uint32_t number) {
    const auto first = static_cast<std::uint32_t>(made.panels.size());
    for (const Patch& patch : part.solid.patches) add_panel(made, number, PanelKind::side, patch.normal, patch.rings, patch.area);
    for (const Seam& seam : part.solid.seams)
        made.hinges.push_back({first + seam.one, first + seam.other, seam.from, seam.to, seam.from, seam.to});
}

// The side that the reader sees, or else the one that is on top, of the two
// that are as large as any.
void add_face(Panels& made, const ModelPart& part, std::uint32_t number, const ViewPlane& view) {
    const Patch* best = nullptr;
    double best_worth = 0;
    for (const Patch& patch : part.solid.patches) {
        if (patch.area < 0.9 * part.solid.patches.front().area) continue;
        double worth = 2 + dot(patch.normal, view.toward) + 0.1 * patch.normal.z - 0.01 * patch.normal.y;
        if (best == nullptr || worth > best_worth + 1e-4) {
            best = &patch;
            best_worth = worth;
        }
    }
    Panel panel{number, PanelKind::side, best->normal, best->rings, best->area};
    // A sheet is seen from both sides.
    if (part.solid.patches.size() == 1 && dot(panel.normal, view.toward) < -1e-6) {
        panel.normal = -1 * panel.normal;
        for (Ring& ring : panel.rings) std::reverse(ring.begin(), ring.end());
    }
    made.panels.push_back(std::move(panel));
}

// As a box whose sides are what it looks like from there.
void add_curved(Panels& made, const ModelPart& part, std::uint32_t number, const ViewPlane& view) {
    const Point3 axes[] = {view.right, -1 * view.down, view.toward};
    const auto first = static_cast<std::uint32_t>(made.panels.size());
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const Point3 normal = sign * axes[axis], u = axes[(axis + 1) % 3], v = sign * axes[(axis + 2) % 3];
            OutlineOfPart outline = outline_of(part.solid, normal, u, v);
            add_panel(made, number, PanelKind::outline, normal, std::move(outline.rings), outline.area);
        }
    // Two neighbours hang together where the box has its edge, be the outline
    // there or not.
    double reach[3][2];  // along each axis, and against it
    for (auto& one : reach) one[0] = one[1] = -std::numeric_limits<double>::infinity();
    for (const Patch& patch : part.solid.patches)
        for (const Ring& ring : patch.rings)
            for (const Point3& point : ring)
                for (int axis = 0; axis < 3; ++axis) {
                    reach[axis][0] = std::max(reach[axis][0], dot(axes[axis], point));
                    reach[axis][1] = std::max(reach[axis][1], -dot(axes[axis], point));
                }
    for (int one = 0; one < 3; ++one)
        for (int other = one + 1; other < 3; ++other)
            for (const double s : {1.0, -1.0})
                for (const double t : {1.0, -1.0}) {
                    // The axes are a right-handed frame.
                    const int third = 3 - one - other;
                    const double u = third == 1 ? -s * t : s * t;
                    const Point3 n = s * axes[one], m = t * axes[other], along = u * axes[third];
                    const Point3 corner = reach[one][s < 0] * n + reach[other][t < 0] * m;
                    const Point3 from = corner - reach[third][u > 0] * along, to = corner + reach[third][u < 0] * along;
                    const auto place = [&](int axis, double sign) {
                        return first + static_cast<std::uint32_t>(2 * axis + (sign < 0));
                    };
                    made.hinges.push_back({place(one, s), place(other, t), from, to, from, to});
                }
}

// The stretch of the first side along which the second runs, from and to as
// shares of the first; empty where they do not meet.
bool runs_along(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double apart, double& from, double& to) {
    const Point3 along = b - a, other = d - c;
    const double length = length_of(along), other_length = length_of(other);
    if (!(length > 0 && other_length > 0) || length_of(cross(along, other)) > kParallel * length * other_length) return false;
    const double at_c = dot(c - a, along) / (length * length), at_d = dot(d - a, along) / (length * length);
    if (length_of(c - a - at_c * along) > apart || length_of(d - a - at_d * along) > apart) return false;
    from = std::clamp(std::min(at_c, at_d), 0.0, 1.0);
    to = std::clamp(std::max(at_c, at_d), 0.0, 1.0);
    return (to - from) * length >= kCommon * std::min(length, other_length);
}

void hinge_parts(Panels& made, const std::vector<ModelPart>& parts, std::uint32_t one, std::uint32_t other) {
    const Panel &a = made.panels[one], &b = made.panels[other];
    if (a.kind != PanelKind::side || b.kind != PanelKind::side || std::abs(dot(a.normal, b.normal)) > 0.99) return;
    const double apart = slack(parts[a.part], parts[b.part]);
    Hinge best;
    double longest = 0;
    for (const Ring& ring : a.rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            for (const Ring& others : b.rings)
                for (std::size_t j = 0; j < others.size(); ++j) {
                    const Point3 &from = ring[i], &to = ring[(i + 1) % ring.size()];
                    const Point3 &c = others[j], &d = others[(j + 1) % others.size()];
                    double begin = 0, end = 0;
                    if (!runs_along(from, to, c, d, apart, begin, end)) continue;
                    const Point3 along = to - from, other_along = d - c;
                    const double length = (end - begin) * length_of(along);
                    if (length <= longest * (1 + 1e-4)) continue;
                    longest = length;
                    const auto on_other = [&](const Point3& at) {
                        return c + (dot(at - c, other_along) / dot(other_along, other_along)) * other_along;
                    };
                    const Point3 one_from = from + begin * along, one_to = from + end * along;
                    best = {one, other, one_from, one_to, on_other(one_from), on_other(one_to)};
                }
    if (longest > 0) made.hinges.push_back(best);
}

// The panel of the holder that the end lies on, or else the nearest; none where the holder has no panel with a place on it.
std::optional<std::uint32_t> holder_of(const Panels& made, const std::vector<std::uint32_t>& first, std::uint32_t part,
                                       const Point3& end, const ViewPlane& view) {
    std::optional<std::uint32_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t place = first[part]; place < first[part + 1]; ++place) {
        const Panel& panel = made.panels[place];
        if (panel.rings.empty()) continue;  // the shadow of something flat
        const double off = dot(panel.normal, end - panel.rings.front().front());
        double worth = std::abs(off) - 1e-3 * dot(panel.normal, view.toward);
        if (!is_over(end - off * panel.normal, panel.normal, panel.rings)) worth += std::sqrt(panel.area);
        if (worth < least - 1e-4 * std::abs(least) || !best) {
            least = worth;
            best = place;
        }
    }
    return best;
}

void add_bars(Panels& made, const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing,
              const std::vector<std::uint32_t>& first, const SpaceGrid& near, const ViewPlane& view) {
    for (std::uint32_t place = 0; place < parts.size(); ++place) {
        const ModelPart& part = parts[place];
        if (part.form != PartForm::line) continue;
        const auto ends = ends_of(part);
        Bar bar{.part = place, .held = ends[0], .loose = ends[1]};
        std::uint32_t holders[2] = {};
        bool held[2] = {};
        for (int end = 0; end < 2; ++end) {
            double least = std::numeric_limits<double>::infinity();
            const double most = 2 * part.box.half[1] + kLoose * part.box.half[0];
            for (const std::uint32_t other : near.near(grown(SpaceBox{ends[end], ends[end]}, most))) {
                if (other == place || thing[other] != thing[place] || parts[other].form == PartForm::line) continue;
                const double off = distance(ends[end], parts[other]);
                if (off > most || off >= least) continue;
                least = off;
                held[end] = true;
                holders[end] = other;
            }
        }
        bar.ends_held = static_cast<int>(held[0]) + static_cast<int>(held[1]);
        const int holding = held[0] ? 0 : 1;
        if (bar.ends_held > 0) {
            bar.held = ends[static_cast<std::size_t>(holding)];
            bar.loose = ends[static_cast<std::size_t>(1 - holding)];
            if (const auto holder = holder_of(made, first, holders[holding], bar.held, view))
                bar.holder = *holder;
            else
                bar.ends_held = 0;
        }
        made.bars.push_back(bar);
    }
}

// A face that is seen from its side is a line there.
void add_edge(Panels& made, const ModelPart& part, std::uint32_t place, const ViewPlane& view) {
    const Point3 normal = part.box.axis[2];
    if (std::abs(dot(normal, view.toward)) > kLevel) return;
    const Point3 way = unit(cross(view.toward, normal));
    const Stretch wide = stretch_of(part.solid, way), near = stretch_of(part.solid, view.toward);
    const Point3 up = cross(normal, way);
    const Point3 middle = dot(part.box.middle, normal) * normal + (dot(up, view.toward) > 0 ? near.high : -near.high) * up;
    made.bars.push_back({.part = place, .held = middle + wide.low * way, .loose = middle + wide.high * way, .is_edge = true});
}

}  // namespace

Panels panels_of(const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing, const ViewPlane& view) {
    Panels made;
    std::vector<std::uint32_t> first;
    for (std::uint32_t place = 0; place < parts.size(); ++place) {
        first.push_back(static_cast<std::uint32_t>(made.panels.size()));
        switch (parts[place].form) {
            case PartForm::solid: add_sides(made, parts[place], place); break;
            case PartForm::face: add_face(made, parts[place], place, view); break;
            case PartForm::round: add_round(made, parts[place], place, view); break;
            case PartForm::curved: add_curved(made, parts[place], place, view); break;
            case PartForm::line: break;
        }
    }
    first.push_back(static_cast<std::uint32_t>(made.panels.size()));
    std::vector<SpaceBox> extents, grown_extents;  // grown: those of two parts meet that are no farther apart than their slack
    for (const ModelPart& part : parts) {
        extents.push_back(space_of(part));
        grown_extents.push_back(grown(extents.back(), slack(part, part) / 2));
    }
    const SpaceGrid near(grown_extents);
    for (std::uint32_t a = 0; a < parts.size(); ++a)
        for (const std::uint32_t b : near.near(grown_extents[a])) {
            if (b <= a || thing[a] != thing[b] || apart(extents[a], extents[b]) > slack(parts[a], parts[b])) continue;
            // Boxes that stand side by side are not hinged, boards are.
            if (parts[a].form != PartForm::face && parts[b].form != PartForm::face) continue;
            for (std::uint32_t one = first[a]; one < first[a + 1]; ++one)
                for (std::uint32_t other = first[b]; other < first[b + 1]; ++other) hinge_parts(made, parts, one, other);
        }
    const SpaceGrid where(std::move(extents));
    add_bars(made, parts, thing, first, where, view);
    for (std::uint32_t place = 0; place < parts.size(); ++place)
        if (parts[place].form == PartForm::face) add_edge(made, parts[place], place, view);
    add_hanging(made, parts, thing, where, view);
    return made;
}

}  // namespace tactics
