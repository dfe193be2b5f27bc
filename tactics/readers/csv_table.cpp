// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/csv_table.h"

#include <algorithm>

#include "tactics/error.h"
#include "tactics/readers/cell.h"
#include "tactics/readers/csv.h"

namespace tactics {

namespace {

[[noreturn]] void fail(const std::string& name, std::size_t line, const Phrase& message) {
    throw Error(Fault::failed, name + ":" + std::to_string(line), message);
}

// A comment names columns if it has as many words as there are, none of them a number.
std::vector<std::string> names_in(const std::string& comment, char separator, std::size_t count) {
    const auto cells = cells_of(comment, separator);
    if (cells.size() != count || std::any_of(cells.begin(), cells.end(), is_number)) return {};
    return {cells.begin(), cells.end()};
}

void check_count(const TableHead& head, std::size_t line, std::size_t cells, bool ended) {
    if (cells == head.columns.size()) return;
    const Phrase mend = !ended                              ? phrase("the file seems to end in the middle; get all of it")
                        : head.separator == kBlankSeparator ? phrase("write NaN where nothing is known")
                                                            : phrase("write a value with a comma in it in double quotes");
    fail(head.name, line,
         phrase("there are {0} values for {1} columns; {2}", std::to_string(cells), std::to_string(head.columns.size()), mend));
}

std::size_t file_size(const Source& source) {
    std::fseek(source.file.get(), 0, SEEK_END);
    const long size = std::ftell(source.file.get());
    std::rewind(source.file.get());
    return size > 0 ? static_cast<std::size_t>(size) : 0;
}

}  // namespace

TableHead csv_table_head(Source& source) {
    TableHead head;
    head.name = source.name;
    if (source.file != nullptr) head.separator = separator_of(source);
    CsvRecords records(source, head.separator);
    std::vector<bool> ended;
    while (head.rows.size() <= kHeadRows && records.bytes() < kHeadBytes && records.next()) {
        head.rows.push_back({records.line(), {records.cells().begin(), records.cells().end()}});
        ended.push_back(records.ended());
    }
    if (head.rows.empty())
        throw Error(Fault::failed, head.name, phrase("there is no line in it; the first names the columns: dots a page,F"));
    head.rows_expected = file_size(source) / std::max<std::size_t>(1, records.bytes() / head.rows.size()) + 1;
    const TableRow first = head.rows.front();
    const std::size_t count = head.rows.size() > 1 ? head.rows[1].cells.size() : first.cells.size();
    std::vector<std::string> names = names_in(records.comment(), head.separator, first.cells.size());
    const bool some =
        std::any_of(first.cells.begin(), first.cells.end(), [](const std::string& cell) { return is_number(cell); });
    if (some && !names.empty()) {
        name_columns(head, std::move(names), first.line);
    } else if (holds_values(first.cells)) {
        name_columns_by_number(head, first.cells.size());
    } else {
        head.skipped = 1;
        names = first.cells;
        if (names.size() + 1 == count && leaves_out_row_names(head.separator)) {
            names.insert(names.begin(), "row");
            head.row_names = true;
        }
        name_columns(head, std::move(names), first.line);
        head.rows.erase(head.rows.begin());
        ended.erase(ended.begin());
    }
    if (head.rows.empty())
        throw Error(Fault::failed, head.name,
                    phrase("the table has names of columns and no rows; write lines of values below the names"));
    if (head.rows.size() > kHeadRows) head.rows.pop_back();
    for (std::size_t i = 0; i < head.rows.size(); ++i) check_count(head, head.rows[i].line, head.rows[i].cells.size(), ended[i]);
    return head;
}

void read_csv_rows(Source& source, const TableHead& head, std::span<const std::size_t> wanted, const TakeRow& take) {
    CsvRecords records(source, head.separator);
    std::vector<std::string_view> cells(wanted.size());
    std::size_t rows = 0;
    for (std::size_t i = 0; i < head.skipped; ++i) records.next();
    while (records.next()) {
        if (rows++ == kMostTableRows)
            fail(head.name, records.line(),
                 phrase("there are more than {0} rows; keep every tenth or hundredth, for example: awk 'NR % 100 == 1' FILE",
                        std::to_string(kMostTableRows)));
        check_count(head, records.line(), records.cells().size(), records.ended());
        for (std::size_t i = 0; i < wanted.size(); ++i) cells[i] = records.cells()[wanted[i]];
        take(records.line(), cells, records.apart());
    }
}

}  // namespace tactics
