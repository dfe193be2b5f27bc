// SPDX-License-Identifier: Apache-2.0
// The meaning of a table's columns, and how to draw them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/plot.h"
#include "tactics/readers/cell.h"
#include "tactics/text/date.h"

namespace tactics {

/// How columns of a table are drawn as bars.
enum class BarKind : std::uint8_t {
    grouped,  ///< side by side
    stacked,  ///< on each other
    pie,      ///< one column, as percentages of its sum: the contents of a pie chart, whose angles a finger cannot compare
};

/// Column names have their unit or not; empty: see each.
struct TableWish {
    std::string x = {};                     ///< from left to right; the first column of numbers or dates
    std::string y = {};                     ///< upwards; the next column of numbers
    std::vector<std::string> other_y = {};  ///< further y columns: a curve or a bar for each
    std::string z = {};                     ///< heights over x and y: a surface if x and y form a grid, else marks in space;
                                            ///< empty: none
    std::string group = {};                 ///< a curve for each of its values; empty: one curve of all rows
    std::string label = {};                 ///< a row with words in this column is a mark with that name; empty: none
    bool points = false;                    ///< each row a mark, and no curves
    std::optional<int> histogram = {};      ///< histogram of x with this many bins; 0: as many as suit its values
    bool matrix = false;                    ///< heights in rows, perhaps with x in the first row and y in the first column
    std::optional<BarKind> bars = {};       ///< a bar for each row, named by x, which may be words; nothing: curves
    BarWay bar_way = BarWay::automatic;
    std::vector<std::string> errors = {};             ///< error of each y, up and down; none, or one per y
    std::vector<std::string> lower = {}, upper = {};  ///< alternatively the lower and the upper limit of each y; both or neither
    bool steps = false;                               ///< level from each row to the next
    bool log_x = false, log_y = false;
    std::optional<Decimal> decimal = {};  ///< notation of its numbers; nothing: as in its first rows
    std::optional<Decimal> written = {};  ///< on the page; nothing: as in the table
    std::string language = "en";          ///< of the words that the plot has besides those of the table (BCP 47)
    std::optional<DateOrder> dates = {};  ///< order in its dates; nothing: as in its first rows
};

inline constexpr std::size_t kMostTableMarks = 10'000;  // many times what a page can show
inline constexpr std::size_t kMostTableCurves = 1000;   // likewise
inline constexpr std::size_t kMostTableTurns = 10'000;  // turns of a curve from left to right; with more it is a blot

}  // namespace tactics
