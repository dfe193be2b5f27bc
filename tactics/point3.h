// SPDX-License-Identifier: Apache-2.0
// A position or a direction in space.
#pragma once

#include <cmath>

namespace tactics {

/// On a map: x and y as in Point (x to the right, y downwards), z upwards. In mm unless its user states another unit.
struct Point3 {
    double x = 0;
    double y = 0;
    double z = 0;
    bool operator==(const Point3&) const = default;
};

constexpr Point3 operator+(const Point3& a, const Point3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Point3 operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Point3 operator*(double by, const Point3& a) { return {by * a.x, by * a.y, by * a.z}; }
constexpr double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Point3 cross(const Point3& a, const Point3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline bool is_finite(const Point3& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }
inline double length_of(const Point3& a) { return std::sqrt(dot(a, a)); }
/// The unit vector in the same direction; zero stays zero.
inline Point3 unit(const Point3& a) {
    const double length = length_of(a);
    return length > 0 ? 1 / length * a : Point3{};
}
/// The same direction, and no longer than `most`.
inline Point3 within(const Point3& a, double most) {
    const double length = std::hypot(a.x, a.y, a.z);  // finite for all finite points
    return length > most ? Point3{a.x / length * most, a.y / length * most, a.z / length * most} : a;
}

}  // namespace tactics
