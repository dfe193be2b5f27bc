// SPDX-License-Identifier: Apache-2.0
// Places the letters of a chart: beside the thing that they name, clear of everything drawn.
#pragma once

#include <string>
#include <vector>

#include "filters/cell_places.h"
#include "tactics/layout/label.h"
#include "tactics/page.h"

namespace tactics {

constexpr double kChartClear = 3.2;  // mm between things that must not touch: the gap of swell paper
constexpr double kChartLines = 3.5;  // mm between blocks of words: lines of braille are 10 mm apart
constexpr double kChartTick = 6.35;  // mm on each side of the axis: 1/4 in (rules/tick_sides.cpp)

/// Clearances around words. An embosser shifts words to whole cells, by up to half a cell, and chains of dots by up to half the
/// gap between cells or lines.
struct Clearance {
    double across = 0;  ///< words to the middle of a thin line, mm
    double down = 0;
    double words = 0;                     ///< words to words beside them
    double mark = 0;                      ///< radius: clearly larger than a braille dot (rules/symbol_size.cpp)
    double set_across = 0, set_down = 0;  ///< from words that stand where they will be set (CellPlaces) to the middle of a line
};
Clearance clearance_on(const Medium& medium);

/// a, b, ... z, aa, ab ...: the letter beside a thing and at the beginning of its line in the key.
std::string letter_of(std::size_t index);

/// A letter and the thing that it names.
struct ChartTag {
    std::vector<Point> places;  ///< of the named thing: a mark's middle, or points of a curve, the best first
    std::string letter;
    LabelBlock block;
    std::vector<std::size_t> curve;  ///< the strokes of the drawing that it names
    Point at{};                      ///< that of `places` at which it stands
    Rect place{};
    bool placed = false;
};

/// The things from which letters keep clear.
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

/// Finds the best possible place for every tag.
void place_letters(std::vector<ChartTag>& tags, const ChartGround& ground);

/// From what is named to its words, if they are far; empty if they are near.
std::vector<Point> lead_of(const ChartTag& tag, const Clearance& clear);

}  // namespace tactics
