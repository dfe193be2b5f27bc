// SPDX-License-Identifier: Apache-2.0
// The legend of a bar chart: which of its samples is filled as which bars are.
#pragma once

#include <vector>

#include "filters/lab.h"
#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// For each of these samples a place at a bar of its kind, pixels. A sample is so small that its hatch is not seen well, so all
/// are matched at once, each with a kind of its own. Empty unless that is clear for all of them.
std::vector<Point> bars_like(const Image& picture, const PixelColour& ground, const std::vector<PixelBox>& samples);

/// Whether it has bars of several kinds, so that a hatch in it may be one of several.
bool has_several_fills(const Image& picture, const PixelColour& ground);

}  // namespace tactics
