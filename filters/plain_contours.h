// SPDX-License-Identifier: Apache-2.0
// Contours without training, before thinning: they use colour and lightness, sum strengths along lines, suppress texture by the
// quieter of the two sides, and leave out edges that noise alone could cause.
#pragma once

#include "tactics/image.h"

namespace tactics {

struct PlainContours {
    double blur = 2;      ///< pixels, the deviation of the Gaussian before it
    double along = 6;     ///< pixels: length along lines over which strengths are summed (standard deviation)
    double chroma = 1.5;  ///< weight of a step in colour relative to one in lightness
    double surround = 1;  ///< share of the mean strength beside a line, on its quieter side, to subtract
    double floor = 0;     ///< grey levels: weaker steps are no contours
};

struct PlainMap {
    EdgeMap edges;     ///< not thinned; but thinned and without edges if there is nothing in the picture
    double noise = 0;  ///< grey levels that noise alone reaches in few pictures
};

PlainMap plain_contours(const Image& picture, const PlainContours& wish);

}  // namespace tactics
