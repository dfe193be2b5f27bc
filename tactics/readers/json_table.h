// SPDX-License-Identifier: Apache-2.0
// Tables in JSON (RFC 8259): interprets rows and columns, value by value, within bounds.
#pragma once

#include <span>

#include "tactics/readers/read.h"
#include "tactics/readers/table.h"

namespace tactics {

/// Whether its first letter begins an object or an array.
bool begins_json(const Source& source);

/// An array of objects, whose names are the columns; an array of arrays, a row each; an array of values, one column; an object of
/// arrays, which are the columns, and whose single values are left out; or one in which z is an array of arrays, a surface over x
/// and y. null, NaN and a name that is not there are gaps. Rows are counted by their lines. Throws Error with the line and the
/// letter in it.
TableHead json_table_head(Source& source);

/// As read_rows of read_table.h. The columns of an object come one after another, so their text is kept until the last has
/// arrived: at most kMostJsonColumns bytes.
void read_json_rows(Source& source, const TableHead& head, std::span<const std::size_t> wanted, const TakeRow& take);

inline constexpr std::size_t kMostJsonColumns = std::size_t{512} << 20;

}  // namespace tactics
