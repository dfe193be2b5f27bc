// Tables of words and numbers, to read and for a spreadsheet.
#pragma once

#include <string>
#include <vector>

namespace tactics {

/// The first row has the headings; all rows are equally long.
using TableRow = std::vector<std::string>;

/// Without the locale, with all its digits: "0.640".
std::string fixed(double value, int digits);
std::string percent(double share);  ///< "42 %"

/// Columns of even width, the first and the last to the left, numbers between them to the right. A field that is empty is "-",
/// but for the last.
std::string table_text(std::vector<TableRow> rows);

/// With commas (RFC 4180).
std::string table_csv(const std::vector<TableRow>& rows);

}  // namespace tactics
