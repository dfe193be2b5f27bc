// SPDX-License-Identifier: Apache-2.0
// Bars of a chart as they are felt: straight outlines, of two that are close one line, and a filling for each kind.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/box.h"

namespace tactics {

/// How the bars of one kind look.
struct BarPaint {
    bool blank = false, hatched = false;
    double dark = 0;  ///< mean, 0 white to 1
};

struct ChartBar {
    Box box;               ///< mm: the middles of its sides
    std::size_t look = 0;  ///< number of its kind
};

struct ChartBars {
    std::vector<ChartBar> bars;
    std::vector<BarPaint> looks;
    bool lying = false;    ///< from left to right, or from right to left; else upright
    double base = 0;       ///< mm: y of the line that they stand on, or x of that of lying ones
    bool on_axis = false;  ///< that line goes on beyond them, and is drawn by itself
};

struct FeltBars {
    std::vector<Stroke> strokes;  ///< mm; without strength
    std::vector<Area> areas;
};

/// Bars too thin for a finger become wider where there is room between their groups; nothing where there is none. Wide ones have
/// textures. What is narrower than a texture needs is told apart by rungs from side to side, close or far apart, a line along its
/// middle, and a black surface; the palest kind is blank. Where there are more kinds than fillings all are blank.
FeltBars felt_bars(const ChartBars& bars);

}  // namespace tactics
