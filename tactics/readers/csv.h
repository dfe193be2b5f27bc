// SPDX-License-Identifier: Apache-2.0
// Tables as files of values between commas (RFC 4180), read within bounds.
#pragma once

#include <string>
#include <vector>

#include "tactics/readers/read.h"

namespace tactics {

struct CsvRow {
    std::size_t line = 0;            ///< of the file, from 1
    std::vector<std::string> cells;  ///< as many as there are columns
};

struct Csv {
    std::string name;  ///< of the file, for messages
    std::vector<std::string> columns;
    std::vector<CsvRow> rows;
};

inline constexpr std::size_t kMostCsvRows = 10'000;  // many times what a chart on a page can show
inline constexpr std::size_t kMostCsvColumns = 1000;
inline constexpr std::size_t kLongestCsvLine = 65'536;  // bytes

/// The first line names the columns. Values stand between commas (tabs or semicolons, if the first line has no comma but between
/// digits), in double quotes if need be; blanks around them and empty lines do not count. Each is UTF-8 in one line. Throws Error
/// with the line.
Csv read_csv(const Source& source);

}  // namespace tactics
