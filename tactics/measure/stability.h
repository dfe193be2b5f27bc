// SPDX-License-Identifier: Apache-2.0
// Whether a drawing holds when its picture changes in a way that does not matter.
#pragma once

#include <string_view>
#include <vector>

#include "tactics/image.h"
#include "tactics/measure/matching.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Agreement of the lines drawn on a changed picture with those drawn on the original: F of the one-to-one matching within 0.75 %
/// of the diagonal. 1 if neither has lines, 0 if one of them has none.
double agreement(const PixelSet& before, const PixelSet& after);

/// A picture of which it is known what is to be found in it.
struct KnownPicture {
    SourceWords name;
    std::string_view summary;
    Image image;
    PixelSet contour;  ///< empty: there is nothing to be found
};

/// Flat and ramp, alone and with noise, a texture; then a faint disc, and one that only its colour parts from its ground.
std::vector<KnownPicture> known_pictures();

/// The share of a map's pixels that are lines.
double ink_of(const PixelSet& lines);

}  // namespace tactics
