// SPDX-License-Identifier: Apache-2.0
// Lines of a broad pen, which an edge detector sees as two edges, too near each other for a finger.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Pixels.
struct PenWidths {
    double narrowest = 0, widest = 0;
    bool bent_only = false;  ///< what is straight and upright or level is a bar
};

/// Strokes of an even width between these, several times as long as wide, are put into a thinned map by their middles, with their
/// contrast as strength, in place of the edges within `beside` pixels of them. What crosses them goes on. A map without such
/// strokes stays as it is.
void add_thick_lines(EdgeMap& edges, const Image& picture, PenWidths pens, double beside);

}  // namespace tactics
