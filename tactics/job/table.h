// SPDX-License-Identifier: Apache-2.0
// A table of numbers as a plot: which of its columns is what.
#pragma once

#include <string>
#include <vector>

#include "tactics/plot.h"
#include "tactics/readers/csv.h"

namespace tactics {

/// Columns are named with their unit or without; empty: see each.
struct TableWish {
    std::string x;        ///< from left to right; the first column of numbers
    std::string y;        ///< upwards; the next column of numbers
    std::string group;    ///< a curve for each of its values; one of all rows
    std::string label;    ///< a row with words in it is a mark of that name; none
    bool points = false;  ///< each row a mark, and no curves
    bool log_x = false, log_y = false;
};

/// Rows without a number are left out, and `notes` is told how many. Throws Error: usage for a wish that names no column, and
/// failed, with the line, for what is no number.
Plot plot_of(const Csv& csv, const TableWish& wish, std::vector<std::string>& notes);

}  // namespace tactics
