// SPDX-License-Identifier: Apache-2.0
// A position or a direction in space, and which way is up.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

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

/// Which axis of a file points upwards: OBJ, PLY and STL do not say, and tools for printing write z upwards, others, such as
/// Blender, y. With x upwards, -y points to the right and -z away from the reader; with y upwards, x and -z; with z upwards, x
/// and y (COLLADA 1.4.1, <up_axis>).
enum class UpAxis : std::uint8_t { x, y, z };
constexpr std::string_view name_of(UpAxis up) { return up == UpAxis::x ? "x" : up == UpAxis::y ? "y" : "z"; }

/// A place in world coordinates, of a file in which the axis `from` pointed upwards, if it is `to` that does; turned and not
/// mirrored.
constexpr Point3 turned_up(const Point3& at, UpAxis from, UpAxis to) {
    const auto [right, away, up] = at;
    const Point3 file = from == UpAxis::x ? Point3{up, -right, -away} : from == UpAxis::y ? Point3{right, up, -away} : at;
    return to == UpAxis::x ? Point3{-file.y, -file.z, file.x} : to == UpAxis::y ? Point3{file.x, -file.z, file.y} : file;
}

}  // namespace tactics
