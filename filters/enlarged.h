// SPDX-License-Identifier: Apache-2.0
// Enlarges a picture to more pixels.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// The picture at that size, smooth between its pixels. It covers the same place: its longer side keeps its length in mm exactly,
/// the other one to half a pixel.
Image enlarged(const Image& picture, int width, int height);

}  // namespace tactics
