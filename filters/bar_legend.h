// SPDX-License-Identifier: Apache-2.0
// The legend of a bar chart: which of its samples is filled as which bars are.
#pragma once

#include <optional>
#include <vector>

#include "filters/inked_bars.h"
#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// Of a picture whose page nobody knows yet.
std::optional<InkedBars> bars_of(const Image& picture);

/// For each of these samples a place at a bar of its kind, pixels. A sample is so small that its hatch is not seen well, so all
/// are matched at once, each with a kind of its own. Empty unless that is clear for all of them.
std::vector<Point> places_like(const std::vector<PixelBox>& samples, const InkedBars& bars, const Image& picture);

}  // namespace tactics
