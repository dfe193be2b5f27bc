// SPDX-License-Identifier: Apache-2.0
// Finds the picture inside its surroundings: the bars of a film, a black border, a passe-partout.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// The part of the image within bars of one colour on one to four sides; all of it unless that is sure. A bar ends in a sharp
/// edge along the whole side, exactly parallel to it, behind which there is a picture, not just a line. So a night sky, a white
/// studio and the margin of a chart stay. For most images the outermost rows and columns decide.
PixelBox picture_within(const Image& image);

}  // namespace tactics
