// SPDX-License-Identifier: Apache-2.0
// Filled outlines as areas.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// Rings that fill, by the even-odd rule, what these fill by the nonzero rule, as long as no two of them cross.
std::vector<std::vector<Point>> to_even_odd(std::vector<std::vector<Point>> rings);

}  // namespace tactics
