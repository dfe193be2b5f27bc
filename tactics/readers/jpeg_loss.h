// SPDX-License-Identifier: Apache-2.0
// The loss of JPEG: writes a picture and reads it again, in memory.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Stored as JPEG of that quality (1 to 100, as libjpeg counts) with colour at half resolution, and read again.
Image through_jpeg(const Image& image, int quality);

}  // namespace tactics
