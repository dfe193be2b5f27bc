// SPDX-License-Identifier: Apache-2.0
// Filled points in a picture of ink: small discs, alone or on lines.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// In pixels; the middle of the first pixel is (0.5, 0.5).
struct InkedPoint {
    Point middle;
    double radius = 0;
    std::vector<Point> arms;  ///< where the lines that it is on leave it: none, one, two, or two pairs across
};

/// Discs of a radius from `least` (at least 1.8) to `most` pixels. `ink`: grey, darker than 160 is ink.
std::vector<InkedPoint> points_in(const Image& ink, double least, double most);

/// Painted over with what is beside them; lines that they are on go on.
void take_out(Image& picture, const std::vector<InkedPoint>& points);

}  // namespace tactics
