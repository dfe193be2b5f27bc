// SPDX-License-Identifier: Apache-2.0
// The EXIF orientation: which way up the camera was held.
#pragma once

#include <span>

#include "tactics/image.h"

namespace tactics {

/// 1 to 8 as in the EXIF standard (JEITA CP-3451, tag 0x0112): 1 upright, 2 mirrored, 3 upside down, 4 = 2 and 3,
/// 5 transposed, 6 to be turned a quarter clockwise, 7 transposed on the other diagonal, 8 to be turned anticlockwise.
/// `block` starts with the TIFF header ("II*" or "MM."); 1 when it holds no valid orientation.
int exif_orientation(std::span<const unsigned char> block);

/// Whether width and height change places.
inline bool turns_sideways(int orientation) { return orientation >= 5 && orientation <= 8; }

/// The picture in its upright orientation.
Image turn_upright(Image image, int orientation);

}  // namespace tactics
