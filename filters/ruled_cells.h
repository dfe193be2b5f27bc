// SPDX-License-Identifier: Apache-2.0
// What straight level and upright lines enclose in a picture, or borders of colours that run so: bars of a chart, cells of a
// table.
#pragma once

#include <array>
#include <vector>

#include "filters/lab.h"
#include "tactics/image.h"

namespace tactics {

enum class CellFill { ground, colour, hatch };

struct RuledCell {
    PixelBox box;  ///< without its lines
    CellFill fill = CellFill::ground;
    PixelColour colour{};           ///< the middle one of its pixels
    std::array<double, 4> lines{};  ///< how wide its lines are: left, top, right, bottom; pixels
};

/// Pixels: how long lines are at least, how far apart the lines of a hatch at most, how wide a place of one colour is beside
/// whose border there may be a line, and how wide lines are at most. In a coarse hatch there are places of 5, between thin bars
/// none of 9.
struct RulePixels {
    int shortest = 10, hatch = 8, flat = 9, widest = 7;
};

/// The rectangles among them. Cells that the lines of a hatch part are one. Empty where there are more than a few thousand.
std::vector<RuledCell> ruled_cells_in(const Image& picture, const PixelColour& ground, const RulePixels& rules);

/// What that box of the picture is filled with; it has no lines.
RuledCell cell_at(const Image& picture, const PixelColour& ground, const PixelBox& box);

}  // namespace tactics
