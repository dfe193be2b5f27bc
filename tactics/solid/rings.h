// SPDX-License-Identifier: Apache-2.0
// Closed ways in a plane in space, such as the borders of a patch.
#pragma once

#include <vector>

#include "tactics/point3.h"

namespace tactics {

/// The place, which lies in their plane, is within the rings (even-odd rule).
bool is_over(const Point3& at, const Point3& normal, const std::vector<std::vector<Point3>>& rings);
double distance_to_rings(const Point3& at, const std::vector<std::vector<Point3>>& rings);  ///< mm, to the nearest side

}  // namespace tactics
