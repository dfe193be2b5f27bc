// SPDX-License-Identifier: Apache-2.0
// A surface that hangs together: its corners, its faces, and which of their sides meet.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "tactics/point3.h"

namespace tactics {

/// A polygon by its corners, counter-clockwise seen from outside.
using CornerRing = std::vector<std::uint32_t>;

struct WeldedSurface {
    std::vector<Point3> corners;
    std::vector<CornerRing> faces;
    double tolerance = 0;  ///< mm: corners nearer than that were one
};

/// Twice the area, pointing outwards (M. E. Newell's sum; holds for polygons
/// that are bent or not convex).
Point3 doubled_area(const std::vector<Point3>& corners, const CornerRing& ring);

/// Twice the area of each face, pointing outwards.
std::vector<Point3> doubled_areas(const WeldedSurface& surface);

/// Two directions, such as those of areas or sides, that differ by less than a degree.
inline bool go_one_way(const Point3& one, const Point3& other) {
    constexpr double kOneWay = 0.9999;  // cosine
    return dot(one, other) > kOneWay * length_of(one) * length_of(other);
}

/// One side of a face, the way that the face goes round.
struct FaceSide {
    std::uint32_t from, to, face;
};

/// The same whichever way the side is gone.
inline std::uint64_t key_of_side(std::uint32_t one, std::uint32_t other) {
    return static_cast<std::uint64_t>(std::min(one, other)) << 32 | std::max(one, other);
}

/// By their two corners, whichever way they are gone, and of those by their faces.
std::vector<FaceSide> sides_of(const std::vector<CornerRing>& faces);

/// `take` is handed the sides that share their two corners, of sides in the order of `sides_of`.
template <typename Take>
void each_edge(const std::vector<FaceSide>& sides, Take take) {
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() &&
               key_of_side(sides[end].from, sides[end].to) == key_of_side(sides[begin].from, sides[begin].to))
            ++end;
        take(std::span(sides).subspan(begin, end - begin));
    }
}

}  // namespace tactics
