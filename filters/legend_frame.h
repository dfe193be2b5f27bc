// SPDX-License-Identifier: Apache-2.0
// The frame of a legend, which frames nothing when its words stand at what they name.
#pragma once

#include <vector>

#include "tactics/image.h"

namespace tactics {

/// The sides of a level rectangle around the samples and words of a legend, in pixels, that is as near as legends have it and has
/// nothing else in it. A side that goes on beyond its corners, as that of an axis does, is left out. Of a picture whose words are
/// painted over. `height`: of the letters.
std::vector<PixelBox> legend_frame(const Image& picture, const std::vector<PixelBox>& legend, double height);

}  // namespace tactics
