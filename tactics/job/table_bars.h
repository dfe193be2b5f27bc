// SPDX-License-Identifier: Apache-2.0
// Rows of a table as bars.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/table_wish.h"
#include "tactics/plot.h"
#include "tactics/readers/read.h"
#include "tactics/readers/table.h"
#include "tactics/text/phrase.h"

namespace tactics {

inline constexpr std::size_t kMostCategories = 1000;  // many times what a page has room for

/// A bar for each row, or, with groups, one bar per group for each value of x. If no columns are named, all columns of numbers
/// are shown, up to kMostSeries. Throws Error as plot_of does.
Plot bars_plot(Source& source, TableHead& head, const TableWish& wish, std::vector<Phrase>& notes);

}  // namespace tactics
