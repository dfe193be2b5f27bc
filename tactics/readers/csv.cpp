// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/csv.h"

#include <algorithm>

#include "tactics/error.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

[[noreturn]] void fail(const std::string& name, std::size_t line, const std::string& message) {
    throw Error(Fault::failed, name + ":" + std::to_string(line), message);
}

// Whether there was one.
bool next_line(const Source& source, std::size_t number, std::string& line) {
    line.clear();
    for (int c = std::getc(source.file.get());; c = std::getc(source.file.get())) {
        if (c == EOF) {
            if (std::ferror(source.file.get()) != 0) throw Error(Fault::failed, source.name, "it cannot be read");
            return !line.empty();
        }
        if (c == '\n') return true;
        if (line.size() == kLongestCsvLine)
            fail(source.name, number,
                 "the line is longer than " + std::to_string(kLongestCsvLine) + " bytes; is this a table with commas?");
        line += static_cast<char>(c);
    }
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

char separator_of(const std::string& header) {
    // Where tabs or semicolons part the values, a comma between digits is one within a number.
    bool decimal = true;
    for (std::size_t at = header.find(','); at != std::string::npos; at = header.find(',', at + 1))
        decimal &= at > 0 && at + 1 < header.size() && is_digit(header[at - 1]) && is_digit(header[at + 1]);
    if (decimal)
        for (const char separator : {'\t', ';'})
            if (header.find(separator) != std::string::npos) return separator;
    for (const char separator : {',', '\t', ';'})
        if (header.find(separator) != std::string::npos) return separator;
    return ',';
}

std::vector<std::string> cells_of(const std::string& line, char separator, const std::string& name, std::size_t number) {
    std::vector<std::string> cells(1);
    bool quoted = false, closed = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted) {
            if (c != '"')
                cells.back() += c;
            else if (i + 1 < line.size() && line[i + 1] == '"')
                cells.back() += line[++i];
            else
                quoted = false, closed = true;
        } else if (c == separator) {
            if (cells.size() == kMostCsvColumns)
                fail(name, number,
                     "there are more than " + std::to_string(kMostCsvColumns) + " columns; keep those that are to be shown");
            cells.emplace_back();
            closed = false;
        } else if (c == '"' && !closed && cells.back().find_first_not_of(" \t") == std::string::npos) {
            cells.back().clear();
            quoted = true;
        } else if (!closed) {
            cells.back() += c;
        } else if (c != ' ' && c != '\t' && c != '\r') {
            fail(name, number,
                 "something stands between a closing quote and the next value; write a quote within a value twice: \"\"");
        }
    }
    if (quoted) fail(name, number, "a quote is not closed on its line; close it, and keep each row on one line");
    for (std::string& cell : cells) cell = to_line(cell);
    return cells;
}

}  // namespace

Csv read_csv(const Source& source) {
    Csv csv;
    csv.name = source.name;
    char separator = ',';
    std::string line;
    for (std::size_t number = 1; next_line(source, number, line); ++number) {
        if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        if (csv.columns.empty()) {
            separator = separator_of(line);
            csv.columns = cells_of(line, separator, csv.name, number);
            for (std::size_t i = 0; i < csv.columns.size(); ++i)
                if (std::find(csv.columns.begin(), csv.columns.begin() + static_cast<std::ptrdiff_t>(i), csv.columns[i]) !=
                    csv.columns.begin() + static_cast<std::ptrdiff_t>(i))
                    fail(csv.name, number,
                         "two columns are called \"" + beginning_of(csv.columns[i]) +
                             "\"; the first line names each column in its own way");
            continue;
        }
        if (csv.rows.size() == kMostCsvRows)
            fail(csv.name, number,
                 "there are more than " + std::to_string(kMostCsvRows) +
                     " rows; keep every tenth or hundredth, for example: awk 'NR % 100 == 1' FILE");
        CsvRow row{number, cells_of(line, separator, csv.name, number)};
        if (row.cells.size() != csv.columns.size())
            fail(csv.name, number,
                 "there are " + std::to_string(row.cells.size()) + " values for " + std::to_string(csv.columns.size()) +
                     " columns; write a value with a comma in it in double quotes");
        csv.rows.push_back(std::move(row));
    }
    if (csv.columns.empty())
        throw Error(Fault::failed, csv.name, "there is no line in it; the first names the columns: dots a page,F");
    return csv;
}

}  // namespace tactics
