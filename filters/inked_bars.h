// SPDX-License-Identifier: Apache-2.0
// Bars of a chart in a picture: rectangles on one base, beside each other or one on the other, that are filled alike where they
// are of one kind.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "filters/bar_fills.h"
#include "tactics/image.h"
#include "tactics/layout/felt_bars.h"

namespace tactics {

struct InkedBar {
    double left = 0, top = 0, right = 0, bottom = 0;  ///< pixels: the middles of its sides
    std::size_t fill = 0;                             ///< number of its kind
};

struct InkedBars {
    std::vector<InkedBar> bars;
    std::vector<BarFill> fills;
    bool lying = false;  ///< from left to right, or from right to left; else upright
    double base = 0;     ///< pixels: the level, or the upright of lying bars, that they stand on
    std::optional<std::pair<int, int>> axis =
        {};  ///< the first and the last row, or column, of a line that goes on from their base
};

/// Of a picture whose words are painted over. `mm`: of a pixel on the page. Nothing unless at least three stand on one base, not
/// all of one length, with no more than six kinds of filling.
std::optional<InkedBars> inked_bars_in(const Image& picture, const PixelColour& ground, double mm);

/// `mm`: of a pixel.
ChartBars chart_bars_of(const InkedBars& found, double mm);

/// The ground comes where they are, but for their base, if that is an axis, and for what crosses their colours.
void take_out(Image& picture, const PixelColour& ground, const InkedBars& bars);

}  // namespace tactics
