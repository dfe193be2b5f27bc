// SPDX-License-Identifier: Apache-2.0
// A recipe's drawing as a map of lines in the size of the truth, for scoring.
#pragma once

#include "tactics/artwork.h"
#include "tactics/measure/matching.h"

namespace tactics {

/// Places and strengths of lines: the strengths of an edge map; the strokes of a drawing, one pixel wide, and the outlines of its
/// areas; the borders between regions of different value in a picture. Lines without strength are stronger than all others, but a
/// stroke without strength among strokes with strength is weaker than these.
EdgeMap lines_of(const Artwork& artwork, int width, int height);

/// The pixels of strength >= level (> 0 for level 0), thinned to one pixel.
PixelSet cut_at(const EdgeMap& lines, float level);

/// The set thinned to one pixel.
PixelSet thinned(const PixelSet& set);

}  // namespace tactics
