// SPDX-License-Identifier: Apache-2.0
// Columns of a table as curves and marks, and as bars.
#pragma once

#include <string>
#include <vector>

#include "tactics/job/table_columns.h"
#include "tactics/plot.h"
#include "tactics/readers/read.h"
#include "tactics/readers/table.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Throws Error as plot_of does.
Plot curves_plot(Source& source, const TableHead& head, const TableColumns& columns, const TableWish& wish,
                 std::vector<Phrase>& notes);

/// A histogram of the column's values, in the bins of the wish. Throws Error as plot_of does.
Plot histogram_plot(Source& source, const TableHead& head, const TableColumns& columns, const TableWish& wish,
                    std::vector<Phrase>& notes);

}  // namespace tactics
