// SPDX-License-Identifier: Apache-2.0
// A table of any form, row by row: examines its beginning, then reads the requested columns.
#pragma once

#include <span>

#include "tactics/readers/read.h"
#include "tactics/readers/table.h"

namespace tactics {

/// Rewinds the source. The first line names the columns, unless all its values are numbers, dates or gaps; then a comment before
/// it may name them. Throws Error with the line.
TableHead table_head(Source& source);

/// All rows from the first on. Throws Error: as `take` does, or with the line; more than kMostTableRows.
void read_rows(Source& source, const TableHead& head, std::span<const std::size_t> wanted, const TakeRow& take);

}  // namespace tactics
