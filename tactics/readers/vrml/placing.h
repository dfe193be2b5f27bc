// SPDX-License-Identifier: Apache-2.0
// Placement in space: affine maps, composed as in VRML.
#pragma once

#include <span>

#include "tactics/point3.h"

namespace tactics {

/// p' = x p.x + y p.y + z p.z + at
struct Placing {
    Point3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, at{0, 0, 0};

    Point3 operator()(const Point3& p) const { return direction(p) + at; }
    Point3 direction(const Point3& d) const { return d.x * x + d.y * y + d.z * z; }
    /// It turns left hands into right ones, so that faces that looked out look in.
    bool mirrors() const { return dot(cross(x, y), z) < 0; }
};

/// First `inner`, then `outer`.
Placing operator*(const Placing& outer, const Placing& inner);

Placing moved(const Point3& by);
Placing scaled(const Point3& by);
/// About an axis of any length by an angle in radians, counter-clockwise for who looks against it; an axis without length turns
/// nothing.
Placing turned(const Point3& axis, double angle);

/// The fields of a Transform node (ISO/IEC 14772-1, 6.52; the same in VRML 1.0).
struct TransformFields {
    Point3 centre, translation, scale{1, 1, 1};
    Point3 axis{0, 0, 1}, scale_axis{0, 0, 1};
    double angle = 0, scale_angle = 0;
};
/// P' = T C R SR S -SR -C P
Placing placing_of(const TransformFields& fields);

/// The 16 numbers of VRML 1.0's MatrixTransform, which stand a row after another and are multiplied by rows from the left.
Placing placing_of_rows(std::span<const double, 16> rows);

}  // namespace tactics
