// SPDX-License-Identifier: Apache-2.0
// Where the letters of a chart stand: beside what they name, clear of all that is drawn.
#pragma once

#include <string>
#include <vector>

#include "filters/cell_places.h"
#include "tactics/layout/label.h"
#include "tactics/page.h"

namespace tactics {

constexpr double kChartClear = 3.2;  // mm between things that are not to touch: the gap of swell paper
constexpr double kChartLines = 3.5;  // mm between blocks of words: lines of braille are 10 mm apart
constexpr double kChartTick = 6.35;  // mm on each side of the axis: 1/4 in (rules/tick_sides.cpp)

/// How things keep clear of words. An embosser sets words in whole cells, up to half a cell off, and chains of dots up to half
/// the gap between cells or lines off.
struct Clearance {
    double across = 0;  ///< words to the middle of a thin line, mm
    double down = 0;
    double words = 0;                     ///< words to words beside them
    double mark = 0;                      ///< radius: clearly larger than a braille dot (rules/symbol_size.cpp)
    double set_across = 0, set_down = 0;  ///< from words that stand where they will be set (CellPlaces) to the middle of a line
};
Clearance clearance_on(const Medium& medium);

/// a, b, ... z, aa, ab ...: what stands beside a thing and begins its line in the key.
std::string letter_of(std::size_t index);

/// A letter with what it names.
struct ChartTag {
    std::vector<Point> places;  ///< of what it names: a mark's middle, or points of a curve, the best first
    std::string letter;
    LabelBlock block;
    std::vector<std::size_t> curve;  ///< the strokes of the drawing that it names
    Point at{};                      ///< that of `places` at which it stands
    Rect place{};
    bool placed = false;
};

/// What letters keep clear of.
struct ChartGround {
    const Drawing& drawing;  ///< with its axes and curves
    const Medium& medium;
    Clearance clear;
    Rect field;      ///< between the axes
    double top = 0;  ///< where the words above the field end
    const std::vector<Point>& marks;
    const CellPlaces& cells;
    std::vector<Rect> words = {};  ///< that stand in the field already
};

/// Gives every tag its place, as well as it can be done.
void place_letters(std::vector<ChartTag>& tags, const ChartGround& ground);

/// From what is named to its words, if they are far; empty if they are near.
std::vector<Point> lead_of(const ChartTag& tag, const Clearance& clear);

}  // namespace tactics
