// SPDX-License-Identifier: Apache-2.0
// The order of places, in which the last digits of a file make no difference.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tactics/model.h"

namespace tactics {

/// Of places, or of other values in threes, the order along each axis: those in a row, each nearer than `grain` to the next, are
/// equal.
std::vector<std::array<std::uint32_t, 3>> ranks_of(const std::vector<Point3>& places, double grain);

/// Things by their areas (along x), the largest first; of areas that are less than `same` apart by their places.
std::vector<std::uint32_t> by_area_and_place(const std::vector<Point3>& areas, double same, const std::vector<Point3>& places,
                                             double grain);

/// The lowest corner along the first axis, of those as low as that along the second, and so on.
std::vector<Point3>::iterator first_corner(std::vector<Point3>& ring, double grain);

}  // namespace tactics
