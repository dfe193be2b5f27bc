// SPDX-License-Identifier: Apache-2.0
// A picture of more pixels.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// The picture at that size, smooth between its pixels. It covers the same place: `mm_per_pixel` goes down by the widths.
Image enlarged(const Image& picture, int width, int height);

}  // namespace tactics
