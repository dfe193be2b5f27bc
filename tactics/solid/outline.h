// SPDX-License-Identifier: Apache-2.0
// The outline of a solid's shadow from one side.
#pragma once

#include <vector>

#include "tactics/solid/solid.h"

namespace tactics {

struct OutlineOfPart {
    std::vector<std::vector<Point3>> rings;  ///< in the plane that touches the solid on that side; as those of
                                             ///< a Patch
    double area = 0;                         ///< mm2
};

/// Seen against `normal`, with `u` to the right and `v` up (u x v = normal).
/// It reaches as far as the solid; within, found on a grid of 512 cells along the longer side, it is right to 0.2 % of
/// it; rings with an area below four cells are left out.
OutlineOfPart outline_of(const Solid& solid, const Point3& normal, const Point3& u, const Point3& v);

}  // namespace tactics
