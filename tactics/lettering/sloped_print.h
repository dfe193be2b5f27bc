// SPDX-License-Identifier: Apache-2.0
// Print on a slope: the words under an axis that have no room side by side, found by how they stand.
#pragma once

#include <vector>

#include "tactics/lettering/ink.h"

namespace tactics {

/// One piece of such print, as "2019-05-08" under a tick.
struct SlopedWords {
    double slope = 0;  ///< radians; it rises to the right if that is more than 0
    int level = 0;     ///< of grey, between its letters and the ground
    bool light = false;
    double height = 0;  ///< of all its ink, across
    PixelBox box;
    std::vector<InkPiece> pieces;
    bool name = false;  ///< along a street or a side: of no row
};

/// Pieces of print that run in parallel, are alike in size, and begin or end at one height, as those of an axis do; if there are
/// none, names of six letters or more, each at its own slope. Print of less than 12 degrees from level or upright is none.
std::vector<SlopedWords> find_sloped_print(const Image& grey);

/// Along and across print of that slope.
struct SlopedAxes {
    explicit SlopedAxes(double slope);
    double along(double x, double y) const { return x * cosine - y * sine; }
    double across(double x, double y) const { return x * sine + y * cosine; }
    double cosine, sine;
};

}  // namespace tactics
