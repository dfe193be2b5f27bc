// SPDX-License-Identifier: Apache-2.0
// Four boxes and four facets at once, in single precision: what surely is not near a ball is told from what may be. Vectors of
// four numbers as GCC and Clang have them for any machine; their results are the same bits on each.
#pragma once

#include <cstdint>
#include <cstring>

#include "tactics/haptics/scenes/mesh_ball.h"
#include "tactics/point3.h"

namespace tactics {

using Four = float __attribute__((vector_size(16)));
using FourTold = std::int32_t __attribute__((vector_size(16)));  ///< -1 where it is so, else 0

inline Four all_four(float value) noexcept { return Four{value, value, value, value}; }
inline Four larger(Four a, Four b) noexcept { return a > b ? a : b; }
inline Four smaller(Four a, Four b) noexcept { return a < b ? a : b; }
/// Which of the four are told: a bit each.
inline unsigned lanes_of(FourTold told) noexcept {
    const FourTold bits = told & FourTold{1, 2, 4, 8};
    std::uint64_t half[2];
    std::memcpy(half, &bits, sizeof half);
    const std::uint64_t both = half[0] | half[1];
    return static_cast<unsigned>(both | both >> 32) & 15u;
}

/// One place or way, four times.
struct FourPoints {
    Four at[3];
    explicit FourPoints(const Point3& p) noexcept
        : at{all_four(static_cast<float>(p.x)), all_four(static_cast<float>(p.y)), all_four(static_cast<float>(p.z))} {}
};
inline Four dot(const Four* a, const FourPoints& b) noexcept { return a[0] * b.at[0] + a[1] * b.at[1] + a[2] * b.at[2]; }

/// Boxes along the axes, in mm.
struct FourBoxes {
    Four low[3], high[3];
    static constexpr float kNowhere = 1e38f;  ///< where a box is that nothing meets
    FourBoxes() noexcept;
    void take(std::size_t lane, const FourBoxes& from, std::size_t its) noexcept;
};

inline Four squared_distances(const FourBoxes& boxes, const FourPoints& place) noexcept {
    Four sum{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Four off = larger(larger(boxes.low[k] - place.at[k], place.at[k] - boxes.high[k]), Four{});
        sum += off * off;
    }
    return sum;
}

/// A straight way from `start`, with `wide` on all sides of it, up to a share of it.
struct WideWay {
    FourPoints start, inverse;  ///< 1 / way
    float wide, share;
    WideWay(const Point3& from, const Point3& way, float around) noexcept;
};
/// After which share of the way it comes to each box; `reached`: where it does.
inline Four entered(const FourBoxes& boxes, const WideWay& way, FourTold& reached) noexcept {
    Four enter{}, leave = all_four(way.share * (1 + 1e-6f));
    for (std::size_t k = 0; k < 3; ++k) {
        const Four one = (boxes.low[k] - way.wide - way.start.at[k]) * way.inverse.at[k];
        const Four other = (boxes.high[k] + way.wide - way.start.at[k]) * way.inverse.at[k];
        enter = larger(enter, smaller(one, other));
        leave = smaller(leave, larger(one, other));
    }
    reached = enter <= leave * (1 + 1e-5f) + 1e-6f;
    return enter;
}

/// Facets that lie together, in as few bytes as may be: a finger on a large mesh waits for memory most of all. Each has axes of
/// its own, x along its longest side, y across it to the third corner, z over it; and places are told from `origin`, so that
/// single precision is as fine as they are near.
struct alignas(64) FourFacets {
    Four x[3], z[3];        ///< unit; y is their cross product
    Four x0, y0, z0;        ///< of `origin`, in the facet's axes; the longest side goes from 0 to (length, 0)
    Four length;            ///< mm
    Four in_x[2], in_y[2];  ///< across the two other sides, from the end and from the start of it: unit, inwards
    float origin[3], size;  ///< mm; `size`: how far their corners are from `origin` at most, along an axis
    std::uint32_t first, count;
    FourFacets(const FacetCorners* facets, std::uint32_t first, std::uint32_t count) noexcept;  ///< 1 to 4
    /// Those that a ball may meet on its way; the others it does not.
    unsigned may_meet(const Point3& ball, const Point3& way, double radius) const noexcept;
    /// The square of how far they are from a place: each at least so far.
    Four squared_at_least(const Point3& place) const noexcept;

private:
    void take_y(Four* y) const noexcept;
    void put(std::uint32_t lane, const Point3* corners) noexcept;
};

}  // namespace tactics
