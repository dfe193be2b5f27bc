// SPDX-License-Identifier: Apache-2.0
// The lines of a layout: without what nearer things hide, each once, and joined to strokes.
#pragma once

#include <vector>

#include "tactics/solid/layout.h"

namespace tactics {

struct DrawnLines {
    std::vector<Stroke> strokes;
    std::size_t united = 0;  ///< sides that were moved onto others, and those of walls that are too thin to be felt as two lines
};

/// mm of the model. Things that lie on others have thick lines (M. Kurze, CHI 1997: background thin, foreground thick), a side
/// shown twice is dashed, and a bar along the line of sight has no stroke. Where things keep their places, a line closer than
/// `as_one` to a border above it merges with that border; sides beside each other closer than `apart` become one (close_sides.h).
DrawnLines lines_of(const FlatLayout& layout, const std::vector<ModelPart>& parts, const Panels& panels,
                    const std::vector<std::uint32_t>& thing, double as_one = 0, double apart = 0);

}  // namespace tactics
