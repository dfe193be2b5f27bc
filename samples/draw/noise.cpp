// SPDX-License-Identifier: Apache-2.0
#include "samples/draw/noise.h"

namespace tactics::samples {

namespace {
constexpr float ease(float t) { return t * t * (3 - 2 * t); }
}  // namespace

float noise(Vec3 p) {
    const float fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
    const auto x = static_cast<std::int32_t>(fx), y = static_cast<std::int32_t>(fy), z = static_cast<std::int32_t>(fz);
    const float u = ease(p.x - fx), v = ease(p.y - fy), w = ease(p.z - fz);
    const auto edge = [&](int dy, int dz) { return mix(chance(x, y + dy, z + dz), chance(x + 1, y + dy, z + dz), u); };
    return mix(mix(edge(0, 0), edge(1, 0), v), mix(edge(0, 1), edge(1, 1), v), w);
}

float noise2(float px, float py, int seed) {
    const float fx = std::floor(px), fy = std::floor(py);
    const auto x = static_cast<std::int32_t>(fx), y = static_cast<std::int32_t>(fy);
    const float u = ease(px - fx), v = ease(py - fy);
    return mix(mix(chance(x, y, seed), chance(x + 1, y, seed), u), mix(chance(x, y + 1, seed), chance(x + 1, y + 1, seed), u), v);
}

float cloud(Vec3 p, int layers) {
    float sum = 0, weight = 0.5f;
    for (int i = 0; i < layers; ++i, weight *= 0.5f) {
        sum += weight * noise(p);
        p = p * 2.03f + Vec3{17.1f, 5.3f, 9.7f};  // not exactly twice, so that the grids of the layers do not line up
    }
    return sum / (1 - 2 * weight);
}

float cloud2(float x, float y, int layers, int seed) {
    float sum = 0, weight = 0.5f;
    for (int i = 0; i < layers; ++i, weight *= 0.5f) {
        sum += weight * noise2(x, y, seed + i);
        x = x * 2.03f + 17.1f;
        y = y * 2.03f + 5.3f;
    }
    return sum / (1 - 2 * weight);
}

}  // namespace tactics::samples
