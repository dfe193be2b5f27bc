// SPDX-License-Identifier: Apache-2.0
// Where a picture begins inside what surrounds it: the bars of a film, a black border, a passe-partout.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// The part of the image within bars of one colour on one to four sides; all of it unless that is sure. A bar ends in a sharp
/// edge along the whole side, exactly parallel to it, behind which there is a picture and no mere line. So a night sky, a white
/// studio and the margin of a chart stay. Most images are told in their outermost rows and columns.
PixelBox picture_within(const Image& image);

}  // namespace tactics
