// SPDX-License-Identifier: Apache-2.0
// A table of numbers as a plot.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/table_wish.h"
#include "tactics/plot.h"
#include "tactics/readers/read.h"

namespace tactics {

/// Rows are joined in their order. Where nothing is known of y, a curve has a gap; rows without an x are left out; `notes` is
/// told how many. A curve of one point is a ring, and so is a point between two gaps. Throws Error: usage for a wish that names
/// no column or more than can be told apart, and failed, with the line, for what is no number. A pair of numbers is kept in 16
/// bytes, with as much again while the curve grows.
Plot plot_of(Source& source, const TableWish& wish, std::vector<std::string>& notes);

}  // namespace tactics
