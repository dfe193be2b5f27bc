// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/touching_solids.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "tactics/geometry/lots.h"

namespace tactics {

namespace {

constexpr double kSameAngle = 1e-3;  // rad: two faces at a side lie on each other

struct AroundSide {
    double angle;
    bool ends;  // what its face encloses lies before it, in the order of the angles
    std::uint32_t face;
};

// The faces at a side, in their order round it; where one ends and another begins at one angle, they touch, and it ends first.
std::vector<AroundSide> around(const WeldedSurface& surface, const std::vector<Point3>& areas, std::span<const FaceSide> edge) {
    const std::uint32_t low = std::min(edge.front().from, edge.front().to), high = std::max(edge.front().from, edge.front().to);
    const Point3 along = unit(surface.corners[high] - surface.corners[low]);
    const Point3 u = unit(std::abs(along.z) < 0.9 ? cross({0, 0, 1}, along) : cross({1, 0, 0}, along)), v = cross(along, u);
    std::vector<AroundSide> order;
    for (const FaceSide& side : edge) {
        const bool forth = side.from == low;
        const Point3 into = cross(areas[side.face], forth ? along : -1 * along);  // a face is on the left of its side
        order.push_back({std::atan2(dot(into, v), dot(into, u)), forth, side.face});
    }
    std::stable_sort(order.begin(), order.end(), [](const AroundSide& a, const AroundSide& b) { return a.angle < b.angle; });
    // It begins behind the widest gap, so that no two at one angle are the first and the last.
    std::size_t widest = 0;
    double gap = 2 * std::numbers::pi + order.front().angle - order.back().angle;
    for (std::size_t i = 1; i < order.size(); ++i)
        if (order[i].angle - order[i - 1].angle > gap) {
            gap = order[i].angle - order[i - 1].angle;
            widest = i;
        }
    for (std::size_t i = 0; i < widest; ++i) order[i].angle += 2 * std::numbers::pi;
    std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(widest), order.end());
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        for (end = begin + 1; end < order.size() && order[end].angle - order[end - 1].angle < kSameAngle;) ++end;
        std::stable_partition(order.begin() + static_cast<std::ptrdiff_t>(begin),
                              order.begin() + static_cast<std::ptrdiff_t>(end), [](const AroundSide& one) { return one.ends; });
    }
    return order;
}

// Each closed solid by itself: round a side, what begins with one face ends with the next.
std::vector<std::uint32_t> single_solids(const WeldedSurface& surface, const std::vector<Point3>& areas,
                                         const std::vector<FaceSide>& sides) {
    Lots lots(surface.faces.size());
    std::vector<char> open(surface.faces.size(), 0);
    each_edge(sides, [&](std::span<const FaceSide> edge) {
        bool whole = edge.size() % 2 == 0;
        const std::vector<AroundSide> order = whole ? around(surface, areas, edge) : std::vector<AroundSide>{};
        for (std::size_t i = 0; whole && i < order.size(); ++i) whole = order[i].ends != order[(i + 1) % order.size()].ends;
        if (!whole)
            for (const FaceSide& side : edge) open[side.face] = 1;
        for (std::size_t i = 0; whole && i < order.size(); ++i)
            if (!order[i].ends) lots.join(order[i].face, order[(i + 1) % order.size()].face);
    });
    struct Sum {
        bool open = false;
        double volume = 0, area = 0;
    };
    std::vector<Sum> sums(surface.faces.size());
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        const std::uint32_t lot = lots.find(face);
        Sum& sum = sums[lot];
        sum.open = sum.open || open[face] != 0;
        sum.volume += dot(areas[face], surface.corners[surface.faces[face][0]] - surface.corners[surface.faces[lot][0]]) / 6;
        sum.area += length_of(areas[face]) / 2;
    }
    std::vector<std::uint32_t> solid(surface.faces.size(), kNoSolid);
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        const Sum& sum = sums[lots.find(face)];
        if (!sum.open && sum.volume > surface.tolerance * sum.area / 4) solid[face] = lots.find(face);
    }
    return solid;
}

// Of each solid the sides at which its planes meet, from corner to corner and back.
using SolidCorner = std::pair<std::uint32_t, std::uint32_t>;  // solid and corner
using SolidSides = std::map<SolidCorner, std::vector<std::uint32_t>>;

SolidSides sides_of_planes(const std::vector<Point3>& areas, const std::vector<FaceSide>& sides,
                           const std::vector<std::uint32_t>& solid) {
    SolidSides meet;
    each_edge(sides, [&](std::span<const FaceSide> edge) {
        std::map<std::uint32_t, std::vector<std::uint32_t>> faces;  // of each solid
        for (const FaceSide& side : edge)
            if (solid[side.face] != kNoSolid) faces[solid[side.face]].push_back(side.face);
        for (const auto& [one, of] : faces) {
            if (of.size() == 2 && go_one_way(areas[of[0]], areas[of[1]])) continue;
            meet[{one, edge.front().from}].push_back(edge.front().to);
            meet[{one, edge.front().to}].push_back(edge.front().from);
        }
    });
    return meet;
}

// Whether the edge goes straight through there.
bool goes_through(const WeldedSurface& surface, std::uint32_t corner, const std::vector<std::uint32_t>& to) {
    return to.size() == 2 &&
           go_one_way(surface.corners[corner] - surface.corners[to[0]], surface.corners[to[1]] - surface.corners[corner]);
}

}  // namespace

std::vector<SolidOfFace> touching_solids(const WeldedSurface& surface) {
    const std::vector<FaceSide> sides = sides_of(surface.faces);
    bool touch = false;
    each_edge(sides, [&](std::span<const FaceSide> edge) { touch = touch || edge.size() > 2; });
    if (!touch) return std::vector<SolidOfFace>(surface.faces.size());
    const std::vector<Point3> areas = doubled_areas(surface);
    const std::vector<std::uint32_t> own = single_solids(surface, areas, sides);
    const SolidSides meet = sides_of_planes(areas, sides, own);
    Lots lots(surface.faces.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges;  // by their ends
    for (const auto& [begin, ways] : meet) {
        const auto [one, first] = begin;
        if (goes_through(surface, first, ways)) continue;
        for (const std::uint32_t way : ways) {
            std::uint32_t before = first, at = way;
            for (auto on = meet.find({one, at}); goes_through(surface, at, on->second); on = meet.find({one, at}))
                before = std::exchange(at, on->second[0] == before ? on->second[1] : on->second[0]);
            const auto [place, fresh] = edges.emplace(std::minmax(first, at), one);
            if (!fresh) lots.join(place->second, one);
        }
    }
    std::vector<SolidOfFace> solid;
    for (const std::uint32_t one : own) solid.push_back({one, one == kNoSolid ? kNoSolid : lots.find(one)});
    return solid;
}

void set_apart(WeldedSurface& surface, const std::vector<SolidOfFace>& solid) {
    std::map<SolidCorner, std::uint32_t> own;
    for (std::size_t face = 0; face < surface.faces.size(); ++face) {
        if (solid[face].joined == kNoSolid) continue;
        for (std::uint32_t& corner : surface.faces[face]) {
            const auto [place, fresh] =
                own.emplace(SolidCorner(solid[face].joined, corner), static_cast<std::uint32_t>(surface.corners.size()));
            if (fresh) surface.corners.push_back(surface.corners[corner]);
            corner = place->second;
        }
    }
}

}  // namespace tactics
