// SPDX-License-Identifier: Apache-2.0
// Tables as text in lines: which line names the columns, and all rows.
#pragma once

#include <span>

#include "tactics/readers/read.h"
#include "tactics/readers/table.h"

namespace tactics {

/// As in read_table.h.
TableHead csv_table_head(Source& source);
void read_csv_rows(Source& source, const TableHead& head, std::span<const std::size_t> wanted, const TakeRow& take);

}  // namespace tactics
