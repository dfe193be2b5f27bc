// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/backs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tactics/solid/rings.h"
#include "tactics/solid/space_grid.h"

namespace tactics {

namespace {

constexpr double kSameCover = 1e-3;  // of an area, by which that of the other layer may differ
constexpr double kInOnePlane = 3;    // tolerances of welding
constexpr double kTowardCorner = 0.9;

struct LayerFace {
    std::vector<std::vector<Point3>> rings;  // one
    Point3 doubled, normal, middle;
    std::vector<std::uint32_t> over = {};  // those that it lies over
    bool covered = true;                   // by others, at each of its places
    int layer = -1;
};

std::vector<LayerFace> faces_of(const WeldedSurface& surface) {
    std::vector<LayerFace> faces;
    for (const CornerRing& ring : surface.faces) {
        LayerFace& face = faces.emplace_back();
        face.rings.emplace_back();
        for (const Corner corner : ring) {
            face.rings.front().push_back(surface.corners[corner]);
            face.middle = face.middle + (1.0 / static_cast<double>(ring.size())) * surface.corners[corner];
        }
        face.doubled = doubled_area(surface.corners, ring);
        face.normal = unit(face.doubled);
    }
    return faces;
}

// By places in the middle and near the corners: if two layers cover the same, each of them is over one face of the other.
void find_over(std::vector<LayerFace>& faces, double tolerance) {
    std::vector<SpaceBox> boxes;
    for (const LayerFace& face : faces) {
        boxes.push_back(kNoSpace);
        for (const Point3& at : face.rings.front()) take(boxes.back(), at);
    }
    const SpaceGrid grid(std::move(boxes));
    const double off = kInOnePlane * tolerance;
    std::vector<std::uint32_t> met(faces.size(), ~0u);  // the last face that each was found to lie over
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
        LayerFace& one = faces[i];
        std::vector<Point3> places = {one.middle};
        for (const Point3& corner : one.rings.front()) places.push_back(one.middle + kTowardCorner * (corner - one.middle));
        for (const Point3& at : places) {
            if (!is_over(at, one.normal, one.rings) || distance_to_rings(at, one.rings) <= tolerance) continue;
            bool has_other = false;
            grid.any_near(grown(SpaceBox{at, at}, off), [&](std::uint32_t j) {
                const LayerFace& other = faces[j];
                if (i == j || std::abs(dot(one.normal, other.normal)) <= 0.999 ||
                    std::abs(dot(other.normal, at - other.middle)) > off)
                    return false;
                const bool on_edge = distance_to_rings(at, other.rings) <= tolerance;
                const bool inside = !on_edge && is_over(at, other.normal, other.rings);
                has_other = has_other || on_edge || inside;
                if (inside && met[j] != i) {
                    met[j] = i;
                    one.over.push_back(j);
                    faces[j].over.push_back(i);
                }
                return false;
            });
            one.covered = one.covered && has_other;
        }
    }
}

// All that lie over each other from `first` on, each in a layer of its own or the other one; none, if they are more than two
// layers or do not cover the same: as large a place, and each face only what the other layer covers, too.
std::vector<std::uint32_t> two_layers_from(std::uint32_t first, std::vector<LayerFace>& faces) {
    std::vector<std::uint32_t> all = {first};
    faces[first].layer = 0;
    bool are_two = true;
    std::array<double, 2> areas{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const LayerFace& one = faces[all[i]];
        areas[static_cast<std::size_t>(one.layer)] += length_of(one.doubled);
        are_two = are_two && one.covered;
        for (const std::uint32_t other : one.over) {
            if (faces[other].layer == one.layer) are_two = false;
            if (faces[other].layer >= 0) continue;
            faces[other].layer = 1 - one.layer;
            all.push_back(other);
        }
    }
    const bool cover_the_same = std::abs(areas[0] - areas[1]) <= kSameCover * areas[0];
    return are_two && cover_the_same ? all : std::vector<std::uint32_t>{};
}

// Away from the middle; where it lies in the plane, up, to the front, to the right.
double looking_out(const LayerFace& face, const Point3& middle, double slack) {
    const double out = dot(face.normal, face.middle - middle);
    return length_of(face.doubled) * (std::abs(out) > slack ? out : slack * dot(face.normal, {0.01, -0.1, 1}));
}

// From a side into a face, across the side.
Point3 way_into(const WeldedSurface& surface, const CornerRing& ring, Corner from, Corner to) {
    Point3 middle;
    for (const Corner corner : ring) middle = middle + (1.0 / static_cast<double>(ring.size())) * surface.corners[corner];
    const Point3 along = unit(surface.corners[to] - surface.corners[from]), in = middle - surface.corners[from];
    return unit(in - dot(in, along) * along);
}

// Nothing lies over anything where no side has more than two faces, and none is folded back.
bool may_have_backs(const WeldedSurface& surface) {
    constexpr double kFoldedBack = 0.999;             // cosine
    std::vector<std::array<std::uint32_t, 3>> sides;  // the lower corner, the higher one, the face
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face)
        for (std::size_t i = 0; i < surface.faces[face].size(); ++i) {
            const Corner a = surface.faces[face][i], b = surface.faces[face][(i + 1) % surface.faces[face].size()];
            sides.push_back({std::min(a, b), std::max(a, b), face});
        }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const auto [from, to, face] = sides[i];
        const auto has_its_ends = [&, from = from, to = to](std::size_t j) {
            return j < sides.size() && sides[j][0] == from && sides[j][1] == to;
        };
        if (has_its_ends(i + 2)) return true;
        if (has_its_ends(i + 1) && dot(way_into(surface, surface.faces[face], from, to),
                                       way_into(surface, surface.faces[sides[i + 1][2]], from, to)) > kFoldedBack)
            return true;
    }
    return false;
}

}  // namespace

std::size_t drop_backs(WeldedSurface& surface) {
    if (!may_have_backs(surface)) return 0;
    std::vector<LayerFace> faces = faces_of(surface);
    find_over(faces, surface.tolerance);
    SpaceBox all = kNoSpace;
    for (const LayerFace& face : faces)
        for (const Point3& at : face.rings.front()) take(all, at);
    const Point3 middle = 0.5 * (all.low + all.high);
    std::vector<char> dropped(faces.size(), 0);
    for (std::uint32_t first = 0; first < faces.size(); ++first) {
        if (faces[first].layer >= 0 || faces[first].over.empty()) continue;
        const std::vector<std::uint32_t> stack = two_layers_from(first, faces);
        std::array<double, 2> out{};
        for (const std::uint32_t face : stack)
            out[static_cast<std::size_t>(faces[face].layer)] += looking_out(faces[face], middle, 20 * surface.tolerance);
        for (const std::uint32_t face : stack) dropped[face] = (faces[face].layer == 0) == (out[0] < out[1]);
    }
    std::vector<CornerRing> kept;
    for (std::uint32_t face = 0; face < faces.size(); ++face)
        if (dropped[face] == 0) kept.push_back(std::move(surface.faces[face]));
    const std::size_t count = surface.faces.size() - kept.size();
    surface.faces = std::move(kept);
    return count;
}

}  // namespace tactics
