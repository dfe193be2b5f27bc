// SPDX-License-Identifier: Apache-2.0
// Chance that is the same everywhere: no standard distribution (they differ between libraries), no state, no order.
#pragma once

#include <cstdint>

#include "samples/draw/vector.h"

namespace tactics::samples {

/// A well-mixed 32-bit number for a cell of a grid.
constexpr std::uint32_t scramble(std::int32_t x, std::int32_t y, std::int32_t z) {
    // Odd multipliers spread neighbours; the two shift-multiply rounds mix high bits into low ones.
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343u ^ static_cast<std::uint32_t>(y) * 0xd8163841u ^
                      static_cast<std::uint32_t>(z) * 0xcb1ab31fu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 13)) * 0x297a2d39u;
    return h ^ (h >> 16);
}

/// Even chance in [0, 1).
constexpr float chance(std::int32_t x, std::int32_t y, std::int32_t z) {
    return static_cast<float>(scramble(x, y, z) >> 8) * (1.0f / 16777216.0f);
}

/// Smooth noise in [0, 1), one bump to a unit of length.
float noise(Vec3 p);
/// `layers` of it, each half as large and half as strong; about 0.5 on average.
float cloud(Vec3 p, int layers);
/// Noise of a plane.
float noise2(float x, float y, int seed);
float cloud2(float x, float y, int layers, int seed);

}  // namespace tactics::samples
