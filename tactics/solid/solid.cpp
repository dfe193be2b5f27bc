// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "tactics/geometry/box.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/triangulate.h"
#include "tactics/solid/grown_patches.h"
#include "tactics/solid/ranks.h"

namespace tactics {

namespace {

using Corner = std::uint32_t;

constexpr double kCertain = 50;  // tolerances of welding, by which a place may differ from file to file

// Sides of a patch whose other side is not of it, by where they begin.
using Border = std::map<Corner, std::vector<Corner>>;

std::vector<Border> borders_of(const FaceShell& shell, std::uint32_t patches) {
    std::vector<Border> borders(patches);
    for (const auto& half : shell.halves) {
        const std::uint32_t patch = shell.patch[half.face];
        const auto* others = shell.beyond(half.from, half.to);
        const bool inside = others != nullptr && std::any_of(others->begin(), others->end(),
                                                             [&](std::uint32_t other) { return shell.patch[other] == patch; });
        if (!inside) borders[patch][half.from].push_back(half.to);
    }
    return borders;
}

// How far to the left it turns, of directions that lie across `normal`; -pi to
// pi.
double turn(const Point3& normal, const Point3& before, const Point3& after) {
    return std::atan2(dot(normal, cross(before, after)), dot(before, after));
}

// Takes a ring out of the border. Where several go on it turns left, so that no
// ring touches itself.
CornerRing take_ring(Border& border, const WeldedSurface& surface, const Point3& normal) {
    CornerRing ring;
    Corner at = border.begin()->first;
    std::unordered_set<Corner> gone = {at};
    while (true) {
        const auto place = border.find(at);
        if (place == border.end()) break;  // it is open: the surface was not whole
        std::vector<Corner>& ways = place->second;
        std::size_t best = 0;
        if (!ring.empty() && ways.size() > 1) {
            const Point3 before = surface.corners[at] - surface.corners[ring.back()];
            for (std::size_t i = 1; i < ways.size(); ++i)
                if (turn(normal, before, surface.corners[ways[i]] - surface.corners[at]) >
                    turn(normal, before, surface.corners[ways[best]] - surface.corners[at]))
                    best = i;
        }
        ring.push_back(at);
        const Corner next = ways[best];
        ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(best));
        if (ways.empty()) border.erase(place);
        at = next;
        if (gone.insert(next).second) continue;
        const auto again = std::find(ring.begin(), ring.end(), at);
        if (again == ring.begin()) break;
        // A loop that closes early is a separate ring; the path that led to it is returned.
        for (auto one = ring.begin(); one != again; ++one) border[*one].push_back(one + 1 == again ? at : *(one + 1));
        ring.erase(ring.begin(), again);
        break;
    }
    return ring;
}

// The corners of a ring: what lies on the straight line between others is none, nor, of more corners than a hand could tell, what
// is off it by less than a thousandth of the extent.
std::vector<Point3> corners_of(const WeldedSurface& surface, const CornerRing& ring, const Point3& normal) {
    constexpr std::size_t kMostTold = 1000;
    std::vector<Point3> points;
    for (const Corner corner : ring) points.push_back(surface.corners[corner]);
    const Point3 u = unit(std::abs(normal.z) < 0.9 ? cross({0, 0, 1}, normal) : cross({1, 0, 0}, normal)), v = cross(normal, u);
    std::vector<Point> flat;
    for (const Point3& at : points) flat.push_back({dot(at, u), dot(at, v)});
    const Box box = box_of(flat);
    const std::size_t count = flat.size(), half = count / 2;
    double tolerance = 2 * surface.tolerance;
    if (count > kMostTold) tolerance = std::max(tolerance, 1e-3 * std::max(box.width(), box.height()));
    flat.push_back(flat.front());
    std::vector<bool> keep(count + 1, false);
    keep[0] = keep[half] = keep[count] = true;
    keep_course(flat, 0, half, tolerance, keep);
    keep_course(flat, half, count, tolerance, keep);
    // Where it began and was halved there need be no corner.
    for (const std::size_t at : {std::size_t{0}, half}) {
        std::size_t before = (at + count - 1) % count, after = (at + 1) % count;
        while (!keep[before]) before = (before + count - 1) % count;
        while (!keep[after]) after = (after + 1) % count;
        bool straight = before != after && before != at;
        for (std::size_t i = (before + 1) % count; straight && i != after; i = (i + 1) % count)
            straight = distance_to_segment(flat[i], flat[before], flat[after]) <= tolerance;
        if (straight) keep[at] = false;
    }
    std::vector<Point3> corners;
    for (std::size_t i = 0; i < count; ++i)
        if (keep[i]) corners.push_back(points[i]);
    return corners.size() < 3 ? points : corners;
}

Point3 doubled(const std::vector<Point3>& ring) {
    return doubled_area(ring.size(), [&](std::size_t i) { return ring[i]; });
}

Patch patch_of(Border border, const WeldedSurface& surface, const Point3& normal) {
    Patch patch;
    patch.normal = normal;
    while (!border.empty()) {
        const CornerRing ring = take_ring(border, surface, normal);
        if (ring.size() < 3) continue;
        patch.rings.push_back(corners_of(surface, ring, normal));
        patch.area += dot(normal, doubled(patch.rings.back())) / 2;
    }
    std::stable_sort(patch.rings.begin(), patch.rings.end(),
                     [&](const auto& a, const auto& b) { return dot(normal, doubled(a)) > dot(normal, doubled(b)); });
    return patch;
}

// The second goes on straight from the first, which then has both.
bool take_seam(Seam& first, const Seam& second, double tolerance) {
    const Point3 along = first.to - first.from;
    const double length = length_of(along);
    const auto straight = [&](const Point3& at) { return length_of(cross(along, at - first.from)) <= 4 * tolerance * length; };
    if (length_of(first.to - second.from) > 2 * tolerance || !straight(second.from) || !straight(second.to)) return false;
    first.to = second.to;
    return true;
}

void put_in_order(std::vector<Seam>& seams, double tolerance) {
    std::vector<Point3> middles;
    for (const Seam& seam : seams) middles.push_back(0.5 * (seam.from + seam.to));
    const auto where = ranks_of(middles, kCertain * tolerance);
    std::vector<std::size_t> order(seams.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(seams[a].one, seams[a].other, where[a]) < std::tie(seams[b].one, seams[b].other, where[b]);
    });
    std::vector<Seam> sorted;
    for (const std::size_t i : order) sorted.push_back(seams[i]);
    seams = std::move(sorted);
}

// Sides between the same two patches that go on straight are one seam. In the order of the patches, and of where they are.
std::vector<Seam> whole_seams(std::vector<Seam> seams, double tolerance) {
    put_in_order(seams, tolerance);
    std::vector<Seam> whole;
    for (std::size_t begin = 0, end = 0; begin < seams.size(); begin = end) {
        while (end < seams.size() && seams[end].one == seams[begin].one && seams[end].other == seams[begin].other) ++end;
        // By where they begin, so that each finds the one that goes on from it.
        std::map<std::array<double, 3>, std::vector<std::size_t>> from;
        const auto key = [&](const Point3& at, int x, int y, int z) {
            const double cell = 4 * tolerance;
            return std::array{std::floor(at.x / cell) + x, std::floor(at.y / cell) + y, std::floor(at.z / cell) + z};
        };
        for (std::size_t i = begin; i < end; ++i) from[key(seams[i].from, 0, 0, 0)].push_back(i);
        std::vector<char> taken(end - begin, 0);
        const auto next = [&](const Seam& seam) -> std::size_t {
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    for (int z = -1; z <= 1; ++z)
                        if (const auto found = from.find(key(seam.to, x, y, z)); found != from.end())
                            for (const std::size_t i : found->second)
                                if (Seam longer = seam; taken[i - begin] == 0 && take_seam(longer, seams[i], tolerance)) return i;
            return end;
        };
        std::vector<Seam> grown(seams.begin() + static_cast<std::ptrdiff_t>(begin),
                                seams.begin() + static_cast<std::ptrdiff_t>(end));
        for (std::size_t i = begin; i < end; ++i) {
            if (taken[i - begin] != 0) continue;
            for (std::size_t on = next(grown[i - begin]); on != end && on != i; on = next(grown[i - begin])) {
                if (!take_seam(grown[i - begin], grown[on - begin], tolerance)) break;
                taken[on - begin] = 1;
            }
        }
        for (std::size_t i = 0; i < grown.size(); ++i)
            if (taken[i] == 0) whole.push_back(grown[i]);
    }
    put_in_order(whole, tolerance);
    return whole;
}

// The first corner of each ring, and the order of holes of one size.
void put_rings_in_order(Patch& patch, double grain) {
    std::vector<Point3> begins, areas;
    for (auto& ring : patch.rings) {
        std::rotate(ring.begin(), first_corner(ring, grain), ring.end());
        begins.push_back(ring.front());
        areas.push_back({dot(patch.normal, doubled(ring)), 0, 0});
    }
    std::vector<std::vector<Point3>> rings;
    for (const std::uint32_t i : by_area_and_place(areas, 1e-4 * std::abs(areas.front().x), begins, grain))
        rings.push_back(std::move(patch.rings[i]));
    patch.rings = std::move(rings);
}

// That, and the order of patches, do not depend on the order of the faces.
void put_in_order(Solid& solid, double tolerance) {
    const double grain = kCertain * tolerance;
    double largest = 0;
    std::vector<Point3> middles, areas;
    for (Patch& patch : solid.patches) {
        largest = std::max(largest, patch.area);
        middles.push_back(middle_of(patch));
        areas.push_back({patch.area, 0, 0});
        put_rings_in_order(patch, grain);
    }
    const std::vector<std::uint32_t> order = by_area_and_place(areas, 1e-4 * largest, middles, grain);
    std::vector<std::uint32_t> place(order.size());
    std::vector<Patch> patches;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        place[order[i]] = i;
        patches.push_back(std::move(solid.patches[order[i]]));
    }
    solid.patches = std::move(patches);
    for (Seam& seam : solid.seams) {
        seam.one = place[seam.one];
        seam.other = place[seam.other];
        if (seam.one < seam.other) continue;
        std::swap(seam.one, seam.other);  // which goes round it the other way
        std::swap(seam.from, seam.to);
    }
    solid.seams = whole_seams(std::move(solid.seams), tolerance);
}

}  // namespace

Solid solid_of(const WeldedSurface& surface, const std::vector<std::uint32_t>& faces) {
    FaceShell shell{.surface = surface, .rings = {}, .doubled = {}, .halves = {}, .by_side = {}, .patch = {}};
    for (const std::uint32_t face : faces) {
        shell.rings.push_back(surface.faces[face]);
        shell.doubled.push_back(doubled_area(surface.corners, surface.faces[face]));
    }
    for (std::uint32_t face = 0; face < shell.rings.size(); ++face) {
        const CornerRing& ring = shell.rings[face];
        for (std::size_t i = 0; i < ring.size(); ++i) {
            shell.halves.push_back({ring[i], ring[(i + 1) % ring.size()], face});
            shell.by_side[FaceShell::key(ring[i], ring[(i + 1) % ring.size()])].push_back(face);
        }
    }
    const std::uint32_t count = grow_patches(shell);
    std::vector<Border> borders = borders_of(shell, count);
    std::vector<Point3> sums(count);
    for (std::size_t face = 0; face < shell.rings.size(); ++face)
        sums[shell.patch[face]] = sums[shell.patch[face]] + shell.doubled[face];
    Solid solid;
    solid.closed = true;
    for (std::uint32_t patch = 0; patch < count; ++patch) {
        solid.patches.push_back(patch_of(std::move(borders[patch]), surface, (1 / length_of(sums[patch])) * sums[patch]));
        Patch& made = solid.patches.back();
        if (!made.rings.empty()) continue;
        // Its border is not whole: its first face stands for it.
        const auto face = std::find(shell.patch.begin(), shell.patch.end(), patch) - shell.patch.begin();
        made.rings.push_back(corners_of(surface, shell.rings[static_cast<std::size_t>(face)], made.normal));
        made.area = length_of(doubled(made.rings.front())) / 2;
    }
    for (const FaceSide& half : shell.halves) {
        const std::uint32_t one = shell.patch[half.face];
        const auto* others = shell.beyond(half.from, half.to);
        if (others == nullptr) {
            solid.closed = false;
            continue;
        }
        // Where several meet, as at the wall between two cubes, the largest counts: not the first of the file.
        std::uint32_t other = ~0u;
        bool inside = false;
        for (const std::uint32_t face : *others) {
            other = std::min(other, shell.patch[face]);
            inside = inside || shell.patch[face] == one;
        }
        if (inside || one >= other) continue;
        const Patch &left = solid.patches[one], &right = solid.patches[other];
        const Point3 from = surface.corners[half.from], to = surface.corners[half.to];
        const double angle = std::atan2(dot((1 / length_of(to - from)) * (to - from), cross(left.normal, right.normal)),
                                        dot(left.normal, right.normal));
        solid.seams.push_back({one, other, from, to, angle});
    }
    put_in_order(solid, surface.tolerance);
    return solid;
}

bool is_over(const Point3& at, const Point3& normal, const std::vector<std::vector<Point3>>& rings) {
    // Seen along the axis that it faces most.
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    const auto flat = [&](const Point3& p) {
        return z >= x && z >= y ? Point{p.x, p.y} : y >= x ? Point{p.x, p.z} : Point{p.y, p.z};
    };
    const Point place = flat(at);
    bool over = false;
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (ray_meets(place, flat(ring[i]), flat(ring[(i + 1) % ring.size()]))) over = !over;
    return over;
}

double length_of(const Seam& seam) { return length_of(seam.to - seam.from); }

Point3 middle_of(const Patch& patch) {
    Point3 sum;
    for (const Point3& point : patch.rings.front()) sum = sum + point;
    return (1.0 / static_cast<double>(patch.rings.front().size())) * sum;
}

}  // namespace tactics
