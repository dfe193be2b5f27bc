// SPDX-License-Identifier: Apache-2.0
// Heads of arrows in a picture of ink: small, at the end of a line, and the same on both sides of it. Thinned like other ink they
// would be lost, or a blob.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// Places in pixels; the middle of the first pixel is (0.5, 0.5).
struct InkedHead {
    Point tip;
    Point barbs[2];       ///< where they end, to the left and to the right of the line
    Point neck;           ///< on the line, where the head begins
    double shaft = 1;     ///< how wide the line is
    bool dashed = false;  ///< the line has gaps, one before the head

    double length() const { return distance(tip, barbs[0]); }
};

/// Heads that are two strokes, filled, or filled with a notch, of barbs from 4 pixels to `longest`, 12 to 45 degrees from their
/// line. `ink`: grey, darker than 160 is ink. At most about 20,000 line ends are looked at; more is no drawing of lines.
std::vector<InkedHead> arrow_heads_in(const Image& ink, double longest);

/// Painted over with what is beside them; their line goes on to the tip, but for one that has dashes.
void take_out(Image& picture, const std::vector<InkedHead>& heads);

}  // namespace tactics
