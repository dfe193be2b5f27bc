// SPDX-License-Identifier: Apache-2.0
// Rows of text as a table to read and as one for a spreadsheet.
#pragma once

#include <string>
#include <vector>

namespace tactics {

using Row = std::vector<std::string>;

/// Without the locale, with all its digits: "0.640".
std::string fixed(double value, int digits);
std::string percent(double share);
/// To a tenth, and never all where something is left, nor nothing where something is: "> 99.9 %".
std::string exact_percent(double share);

/// Columns stand under each other, two blanks between them; the first and the last start at the left, the others end at the
/// right. What is empty is a "-". All rows have as many fields.
std::string aligned(std::vector<Row> rows);
/// With commas (RFC 4180).
std::string comma_separated(const std::vector<Row>& rows);

}  // namespace tactics
