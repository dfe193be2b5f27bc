// SPDX-License-Identifier: Apache-2.0
// What a recipe drew, as a map of lines of the size of the truth, to be scored against it.
#pragma once

#include "tactics/artwork.h"
#include "tactics/measure/matching.h"

namespace tactics {

/// Where there are lines, and how strong: an edge map's strengths; a drawing's strokes, one pixel wide, and the outlines of
/// its areas; of a picture the borders between regions of different value. What has no strength of its own is stronger than
/// all that has one; a stroke without strength among others that have it is weaker than they.
EdgeMap lines_of(const Artwork& artwork, int width, int height);

/// The pixels of strength >= level (> 0 for level 0), thinned to one pixel.
PixelSet cut_at(const EdgeMap& lines, float level);

/// The set thinned to one pixel.
PixelSet thinned(const PixelSet& set);

}  // namespace tactics
