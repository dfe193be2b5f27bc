// SPDX-License-Identifier: Apache-2.0
// What the bars of a chart are filled with, as it is seen: a colour or a hatch.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "filters/ruled_cells.h"
#include "tactics/image.h"

namespace tactics {

struct BarFill {
    CellFill fill = CellFill::ground;
    PixelColour colour{};          ///< of most of it
    double dark = 0;               ///< mean, 0 white to 1
    double marks = 0;              ///< how many begin along rows and along columns, for each pixel
    double pieces = 0;             ///< pieces of ink that do not touch, for each pixel
    std::array<double, 3> tint{};  ///< how far its mean is off grey in each channel, levels
    std::array<double, 8> ways{};  ///< share of the steps by their direction, from 0 to 180 degrees
};

/// Of a cell of the picture, which has a pixel at least.
BarFill bar_fill_of(const Image& picture, const RuledCell& cell);

/// How different two fills look: below 1 they may be one.
double unlike(const BarFill& a, const BarFill& b);

struct BarKinds {
    std::vector<BarFill> fills;   ///< of each kind, where most of it is seen
    std::vector<std::size_t> of;  ///< number of each fill's kind
};

/// `sizes`: of the surfaces with these fills; in small ones a hatch is not seen as well.
BarKinds kinds_of(const std::vector<BarFill>& fills, const std::vector<double>& sizes);

/// In each of `groups`, numbers of fills that stand beside or on each other, the same kinds follow each other, where most groups
/// say so: a hatch in a few pixels may look like another one. Colours stay what they are.
void even_out(BarKinds& kinds, const std::vector<BarFill>& fills, const std::vector<std::vector<std::size_t>>& groups);

}  // namespace tactics
