// SPDX-License-Identifier: Apache-2.0
// Three numbers: a place, a direction or a colour (linear light, 1 = white paper in full light).
#pragma once

#include <algorithm>
#include <cmath>

namespace tactics::samples {

struct Vec3 {
    float x = 0, y = 0, z = 0;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline float length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 unit(Vec3 a) { return a * (1.0f / std::max(length(a), 1e-12f)); }

constexpr float clamp01(float x) { return x < 0 ? 0 : x > 1 ? 1 : x; }
constexpr float mix(float a, float b, float t) { return a + (b - a) * t; }
constexpr Vec3 mix(Vec3 a, Vec3 b, float t) { return a + (b - a) * t; }

/// 0 below `from`, 1 above `to`, smooth between (also for from > to, falling).
constexpr float ramp(float from, float to, float x) {
    const float t = clamp01((x - from) / (to - from));
    return t * t * (3 - 2 * t);
}

/// A colour as a paint chart gives it (sRGB, 0-255) in linear light.
inline Vec3 paint(int red, int green, int blue) {
    const auto linear = [](int v) { return std::pow(static_cast<float>(v) / 255.0f, 2.2f); };
    return {linear(red), linear(green), linear(blue)};
}

/// Turned about the y axis (yaw, to the viewer's right) and then about the x axis (pitch, downwards), in radians.
struct Turn {
    float yaw_cos = 1, yaw_sin = 0, pitch_cos = 1, pitch_sin = 0;
    Turn(float yaw, float pitch)
        : yaw_cos(std::cos(yaw)), yaw_sin(std::sin(yaw)), pitch_cos(std::cos(pitch)), pitch_sin(std::sin(pitch)) {}
    /// From the world into the turned thing's own frame.
    Vec3 into(Vec3 p) const {
        const float y = pitch_cos * p.y + pitch_sin * p.z;
        const float z = -pitch_sin * p.y + pitch_cos * p.z;
        return {yaw_cos * p.x - yaw_sin * z, y, yaw_sin * p.x + yaw_cos * z};
    }
};

}  // namespace tactics::samples
