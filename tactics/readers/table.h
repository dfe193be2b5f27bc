// SPDX-License-Identifier: Apache-2.0
// A table of any form: its columns, its first rows, and how to read the others.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

inline constexpr std::size_t kMostTableRows = 20'000'000;  // 16 bytes of a pair of numbers each: 320 MB
inline constexpr std::size_t kMostTableColumns = 10'000;
inline constexpr std::size_t kHeadRows = 1000;  // from which is known what columns hold
inline constexpr std::size_t kHeadBytes = 4 * 1024 * 1024;

struct TableRow {
    std::size_t line = 0;            ///< of the file, from 1
    std::vector<std::string> cells;  ///< without blanks around them; as many as there are columns
};

/// How a table is written.
enum class TableForm : std::uint8_t {
    lines,    ///< of values between separators
    records,  ///< JSON: objects, a row each
    arrays,   ///< JSON: arrays, a row each
    values,   ///< JSON: one column
    columns,  ///< JSON: an object of arrays, a column each, so that rows are not in lines but have a number
    heights,  ///< JSON: an object of x, y and the rows of z
};

/// The beginning of a table, and how the rest of it is read.
struct TableHead {
    std::string name;                  ///< of the file, for messages
    std::vector<std::string> columns;  ///< one at least, no two of one name, each UTF-8 in one line
    std::vector<TableRow> rows;        ///< at most kHeadRows
    bool named = true;                 ///< by the file; else "x" and "y", or "column 1"
    bool row_names = false;            ///< the first column has no name and those of the rows, as R writes it
    std::size_t rows_expected = 0;     ///< by the size of the file
    TableForm form = TableForm::lines;
    char separator = ',';            ///< of values in lines
    std::size_t skipped = 0;         ///< rows before the first: that of the names
    std::vector<double> across, up;  ///< x and y of heights; empty: counted from 1
};

/// Receives a row: its line (or number, if there are no lines), the cells in the requested order (valid until the next row), and
/// whether an empty line separates it from the previous row.
using TakeRow = std::function<void(std::size_t line, std::span<const std::string_view> cells, bool apart)>;

/// The same table, its columns named by its first row.
TableHead named_by_first_row(TableHead head);

/// The place of a row, for messages.
std::string place_of_row(const TableHead& head, std::size_t line);

/// Names in one line each; empty ones are replaced by their number. Throws Error if two are equal.
void name_columns(TableHead& head, std::vector<std::string> names, std::size_t line);
void name_columns_by_number(TableHead& head, std::size_t count);

/// Whether all are numbers, dates and gaps, and not all gaps.
bool holds_values(std::span<const std::string> cells);

/// Names of the columns by the first row, if it has no number and no date in it and others follow.
void take_names(TableHead& head);

}  // namespace tactics
