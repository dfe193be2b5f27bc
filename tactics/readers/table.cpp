// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/table.h"

#include <algorithm>
#include <unordered_map>

#include "tactics/error.h"
#include "tactics/readers/cell.h"
#include "tactics/text/date.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

[[noreturn]] void fail_at(const std::string& name, std::size_t line, const Phrase& message) {
    throw Error(Fault::failed, name + ":" + std::to_string(line), message);
}

bool is_date(std::string_view cell) {
    return read_date(cell, DateOrder::year_first).fault != DateFault::other || day_and_month(cell);
}

}  // namespace

bool holds_values(std::span<const std::string> cells) {
    bool some = false;
    for (const auto& cell : cells) {
        const bool value = is_number(cell) || is_date(cell);
        if (!value && !is_gap(cell)) return false;
        some = some || value;
    }
    return some;
}

std::string place_of_row(const TableHead& head, std::size_t line) {
    return head.name + (head.form == TableForm::columns ? ", row " : ":") + std::to_string(line);
}

void name_columns(TableHead& head, std::vector<std::string> names, std::size_t line) {
    std::unordered_map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < names.size(); ++i) {
        names[i] = to_line(names[i]);
        if (names[i].empty()) names[i] = "column " + std::to_string(i + 1);
        if (!known.emplace(names[i], i).second)
            fail_at(head.name, line,
                    phrase("two columns are called \"{0}\"; the first line names each column in its own way",
                           beginning_of(names[i])));
    }
    head.columns = std::move(names);
}

void name_columns_by_number(TableHead& head, std::size_t count) {
    head.named = false;
    if (count == 2 || count == 3) {
        head.columns = {"x", "y", "z"};
        head.columns.resize(count);
        return;
    }
    for (std::size_t i = 1; i <= count; ++i) head.columns.push_back("column " + std::to_string(i));
}

void take_names(TableHead& head) {
    const auto is_value = [](const std::string& cell) { return is_number(cell) || is_date(cell); };
    const std::vector<std::string>& first = head.rows.front().cells;
    if (head.rows.size() < 2 || std::any_of(first.begin(), first.end(), is_value)) return;
    head = named_by_first_row(std::move(head));
}

TableHead named_by_first_row(TableHead head) {
    const TableRow first = head.rows.front();
    head.rows.erase(head.rows.begin());
    head.named = true;
    ++head.skipped;
    name_columns(head, first.cells, first.line);
    return head;
}

}  // namespace tactics
