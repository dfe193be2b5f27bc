// SPDX-License-Identifier: Apache-2.0
// The lines of a layout: without what nearer things hide, each once, and joined to strokes.
#pragma once

#include <vector>

#include "tactics/solid/layout.h"

namespace tactics {

/// mm of the model. What lies on something else is drawn with thick lines (M. Kurze, CHI 1997: background thin, foreground
/// thick), a side that is shown twice as a dashed one, and a bar along the line of sight is no stroke.
/// Where things lie as they are, a line that runs nearer than `as_one` along a border above it is one with that.
std::vector<Stroke> lines_of(const FlatLayout& layout, const std::vector<ModelPart>& parts, const Panels& panels,
                             const std::vector<std::uint32_t>& thing, double as_one = 0);

}  // namespace tactics
