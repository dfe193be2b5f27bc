// SPDX-License-Identifier: Apache-2.0
// Curves that come together, as a finger can still tell them apart.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// The pieces of each curve: the first is whole; of each that follows only what is at least `gap` mm (from middle to middle) from
/// those before it, in pieces no shorter than `least` mm. A line that is crossed is so broken on both sides of the crossing, and
/// two that run together are one line until they part. Courses are simplified by 0.05 mm.
std::vector<std::vector<std::vector<Point>>> curves_apart(const std::vector<std::vector<Point>>& curves, double gap,
                                                          double least);

}  // namespace tactics
