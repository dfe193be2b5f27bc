// SPDX-License-Identifier: Apache-2.0
// Contours without training, before they are thinned: colour counts as well as lightness, strength is collected along lines,
// texture is held down by the quieter of its two sides, and what mere noise would give is left out.
#pragma once

#include "tactics/image.h"

namespace tactics {

struct PlainContours {
    double blur = 2;      ///< pixels, the deviation of the Gaussian before it
    double along = 6;     ///< pixels: strengths are collected along lines of this length (standard deviation)
    double chroma = 1.5;  ///< how much a step in colour counts against one in lightness
    double surround = 1;  ///< this share of the mean strength beside a line, on its quieter side, is taken off
    double floor = 0;     ///< grey levels: weaker steps than this are no contours
};

struct PlainMap {
    EdgeMap edges;     ///< not thinned; thinned and empty if there is nothing in the picture
    double noise = 0;  ///< grey levels: what noise alone reaches in few pictures
};

PlainMap plain_contours(const Image& picture, const PlainContours& wish);

}  // namespace tactics
