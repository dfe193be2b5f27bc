// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/placing.h"

#include <cmath>

namespace tactics {

Placing operator*(const Placing& outer, const Placing& inner) {
    return {outer.direction(inner.x), outer.direction(inner.y), outer.direction(inner.z), outer(inner.at)};
}

Placing moved(const Point3& by) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by}; }

Placing scaled(const Point3& by) { return {{by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}, {0, 0, 0}}; }

Placing turned(const Point3& axis, double angle) {
    const double length = length_of(axis);
    if (!(length > 0) || angle == 0) return {};
    const Point3 u = (1 / length) * axis;
    const double c = std::cos(angle), s = std::sin(angle);
    // Rodrigues: p cos + (u x p) sin + u (u . p)(1 - cos)
    const auto turn = [&](const Point3& p) { return c * p + s * cross(u, p) + (dot(u, p) * (1 - c)) * u; };
    return {turn({1, 0, 0}), turn({0, 1, 0}), turn({0, 0, 1}), {0, 0, 0}};
}

Placing placing_of(const TransformFields& fields) {
    return moved(fields.translation) * moved(fields.centre) * turned(fields.axis, fields.angle) *
           turned(fields.scale_axis, fields.scale_angle) * scaled(fields.scale) * turned(fields.scale_axis, -fields.scale_angle) *
           moved(-1 * fields.centre);
}

Placing placing_of_rows(std::span<const double, 16> rows) {
    const auto row = [&](std::size_t i) { return Point3{rows[4 * i], rows[4 * i + 1], rows[4 * i + 2]}; };
    return {row(0), row(1), row(2), row(3)};
}

}  // namespace tactics
