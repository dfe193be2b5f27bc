// SPDX-License-Identifier: Apache-2.0
// Solids as distance functions: how far a point is from the surface (negative inside). Marched by march.h.
//
// The distance of a box, a capsule or an ellipsoid and the rounded union are textbook geometry (J. C. Hart, "Sphere
// tracing", The Visual Computer 12, 1996; the quadratic blend of two distances is the usual polynomial smooth minimum).
#pragma once

#include "samples/draw/vector.h"

namespace tactics::samples {

inline float ball(Vec3 p, Vec3 centre, float radius) { return length(p - centre) - radius; }

/// Not exact away from the surface, but never too far by much; good enough to march with care.
inline float ellipsoid(Vec3 p, Vec3 centre, Vec3 radii) {
    const Vec3 q = p - centre;
    const Vec3 a{q.x / radii.x, q.y / radii.y, q.z / radii.z};
    const Vec3 b{a.x / radii.x, a.y / radii.y, a.z / radii.z};
    const float outer = length(a);
    const float slope = length(b);
    if (slope < 1e-6f) return -std::min({radii.x, radii.y, radii.z});
    return outer * (outer - 1) / slope;
}

/// A rod with round ends, as thick as `from_radius` at one and `to_radius` at the other.
inline float rod(Vec3 p, Vec3 from, Vec3 to, float from_radius, float to_radius) {
    const Vec3 axis = to - from;
    const float along = clamp01(dot(p - from, axis) / dot(axis, axis));
    return length(p - from - axis * along) - mix(from_radius, to_radius, along);
}

/// Axis-parallel, half its size given, edges rounded.
inline float box(Vec3 p, Vec3 centre, Vec3 half, float round) {
    const Vec3 q = p - centre;
    const Vec3 d{std::abs(q.x) - half.x + round, std::abs(q.y) - half.y + round, std::abs(q.z) - half.z + round};
    const Vec3 out{std::max(d.x, 0.0f), std::max(d.y, 0.0f), std::max(d.z, 0.0f)};
    return length(out) + std::min(std::max({d.x, d.y, d.z}), 0.0f) - round;
}

/// A ring in the plane of x and y.
inline float ring(Vec3 p, Vec3 centre, float radius, float thickness) {
    const Vec3 q = p - centre;
    const float flat = std::sqrt(q.x * q.x + q.y * q.y) - radius;
    return std::sqrt(flat * flat + q.z * q.z) - thickness;
}

/// Union with a fillet of about `blend`.
inline float join(float a, float b, float blend) {
    const float h = std::max(blend - std::abs(a - b), 0.0f) / blend;
    return std::min(a, b) - h * h * blend * 0.25f;
}

/// `a` without `b`, the rim rounded by about `blend`.
inline float carve(float a, float b, float blend) { return -join(-a, b, blend); }

}  // namespace tactics::samples
