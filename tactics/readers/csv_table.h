// SPDX-License-Identifier: Apache-2.0
// Tables as lines of text: finds the line that names the columns, and reads all rows.
#pragma once

#include <span>

#include "tactics/readers/read.h"
#include "tactics/readers/table.h"

namespace tactics {

/// As in read_table.h.
TableHead csv_table_head(Source& source);
void read_csv_rows(Source& source, const TableHead& head, std::span<const std::size_t> wanted, const TakeRow& take);

}  // namespace tactics
