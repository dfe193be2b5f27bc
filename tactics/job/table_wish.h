// SPDX-License-Identifier: Apache-2.0
// Which columns of a table are what, and how they are drawn.
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
    pie,      ///< one column, as shares of its sum in percent: what a pie shows, which a finger cannot compare
};

/// Columns are named with their unit or without; empty: see each.
struct TableWish {
    std::string x = {};                     ///< from left to right; the first column of numbers or dates
    std::string y = {};                     ///< upwards; the next column of numbers
    std::vector<std::string> other_y = {};  ///< besides y: a curve or a bar of each
    std::string z = {};                     ///< heights over x and y: a surface if those are a grid, else marks in space; none
    std::string group = {};                 ///< a curve for each of its values; one of all rows
    std::string label = {};                 ///< a row with words in it is a mark of that name; none
    bool points = false;                    ///< each row a mark, and no curves
    std::optional<int> histogram = {};      ///< how often x is where, in as many bins; 0: as many as its values want
    bool matrix = false;                    ///< heights in rows, perhaps with x in the first row and y in the first column
    std::optional<BarKind> bars = {};       ///< a bar for each row, named by x, which may be words; nothing: curves
    BarWay bar_way = BarWay::automatic;
    std::vector<std::string> errors = {};             ///< how far each y may be off, up and down; none, or as many as there are y
    std::vector<std::string> lower = {}, upper = {};  ///< instead: the least and the largest that each y may be; both or neither
    bool steps = false;                               ///< level from each row to the next
    bool log_x = false, log_y = false;
    std::optional<Decimal> decimal = {};  ///< of its numbers; nothing: as its first rows have it
    std::optional<Decimal> written = {};  ///< on the page; nothing: as in the table
    std::string language = "en";          ///< of the words that the plot has besides those of the table (BCP 47)
    std::optional<DateOrder> dates = {};  ///< of its dates; nothing: as its first rows have it
};

inline constexpr std::size_t kMostTableMarks = 10'000;  // many times what a page can show
inline constexpr std::size_t kMostTableCurves = 1000;   // likewise
inline constexpr std::size_t kMostTableTurns = 10'000;  // of a curve's way from left to right; with more it is a blot

}  // namespace tactics
