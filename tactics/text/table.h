// SPDX-License-Identifier: Apache-2.0
// Rows of text as a table to read and as one for a spreadsheet.
#pragma once

#include <string>
#include <vector>

namespace tactics {

using Row = std::vector<std::string>;

/// Without the locale, with all its digits: "0.640".
std::string fixed(double value, int digits);
/// A mean or estimated count, with tenths only below 10: "3.1", "31".
inline std::string fixed_count(double count) { return fixed(count, count < 10 ? 1 : 0); }
std::string percent(double share);
/// To a tenth, but never 100 % if something is missing, nor 0 % if there is something: "> 99.9 %".
std::string exact_percent(double share);

/// Aligned columns with two blanks between them; the first and the last are left-aligned, the others right-aligned. Empty fields
/// become "-". All rows have the same number of fields.
std::string aligned(std::vector<Row> rows);
/// With commas (RFC 4180).
std::string comma_separated(const std::vector<Row>& rows);

}  // namespace tactics
