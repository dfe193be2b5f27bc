// SPDX-License-Identifier: Apache-2.0
// Any bytes as a table: rows of as many values as there are columns, or one line of what is wrong.
#include <cstdint>
#include <cstdlib>

#include "tactics/error.h"
#include "tactics/readers/csv.h"
#include "tactics/text/utf8.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tactics;
    if (size == 0) return 0;
    try {
        const Csv csv = read_csv(memory_source({data, size}, "fuzzed.csv"));
        if (csv.columns.empty() || csv.columns.size() > kMostCsvColumns || csv.rows.size() > kMostCsvRows) std::abort();
        std::size_t line = 1;
        for (const CsvRow& row : csv.rows) {
            if (row.line <= line || row.cells.size() != csv.columns.size()) std::abort();
            line = row.line;
            for (const std::string& cell : row.cells)
                if (to_line(cell) != cell) std::abort();
        }
    } catch (const Error& error) {
        if (error.what()[0] == '\0') std::abort();
    }
    return 0;
}
