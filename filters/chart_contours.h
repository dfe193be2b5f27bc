// SPDX-License-Identifier: Apache-2.0
// Contours of a surface on a chart: the levels that a finger can tell apart, and the places of their heights.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filters/cell_places.h"
#include "filters/chart_axis.h"
#include "filters/chart_letters.h"

namespace tactics {

struct ChartLevel {
    std::string words;                      ///< its height
    bool index = false;                     ///< drawn thicker: each fifth where there are five
    std::vector<std::vector<Point>> lines;  ///< mm; a closed one ends where it began
    std::optional<Rect> label = {};         ///< where its words stand, in a break of a line; nothing: there is none
};

inline constexpr int kMostContourLevels = 8, kFewestLevels = 3;
inline constexpr double kMostNear = 1.0 / 3;  ///< of all lines

/// The share of lines that are nearer than 6 mm to one of another level.
double share_near(const std::vector<ChartLevel>& levels);

/// Space around words in a break of a line, mm.
Rect kept_by(const Rect& words, const Clearance& clear);

/// The notation of the heights.
struct LevelGround {
    Rect field;
    const Sheet& sheet;
    const CellPlaces& cells;
    Clearance clear;
    Axis height = {};  ///< how heights are written
};

/// Round levels, each with its words in a break of a line where no other line is near: 8, or fewer, down to 3, until all have a
/// place and no more than a third of the lines is nearer than 6 mm to one of another level (APH guide, Bristol: lines closer than
/// that are hard to tell); if none do, those that come nearest. `wanted` levels at most, whatever becomes of that, if it is over
/// 0.
std::vector<ChartLevel> levels_on(const PlotSurface& surface, const AxisScale& across, const AxisScale& up, int wanted,
                                  const LevelGround& ground);

}  // namespace tactics
