// SPDX-License-Identifier: Apache-2.0
// sRGB to CIELAB (white D65), for filters that compare colours as the eye does.
#pragma once

#include <array>
#include <vector>

#include "tactics/image.h"

namespace tactics {

using Lab = std::array<double, 3>;  ///< L* 0 to 100, a*, b* about -128 to 128

/// Channels from 0 to 255.
Lab to_lab(double red, double green, double blue);

/// All pixels of a colour picture as three planes, L* a* b* one after the other, to within 0.02; by tables.
std::vector<std::vector<float>> lab_planes(const Image& picture);

}  // namespace tactics
