// SPDX-License-Identifier: Apache-2.0
// The columns of a table to use, and how to read their values.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/job/table_wish.h"
#include "tactics/readers/table.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A column of numbers or of dates.
struct ValueColumn {
    std::string name;    ///< with its unit
    std::string wish;    ///< the wish that names it: "x"
    std::size_t at = 0;  ///< its index in the table
    bool logarithmic = false;
    std::optional<DateOrder> dates = {};  ///< nothing: numbers
    Decimal decimal = Decimal::point;
};

struct TableColumns {
    std::optional<ValueColumn> x;  ///< nothing: the row number, from 1
    ValueColumn y;
    std::optional<ValueColumn> z;
    std::vector<ValueColumn> other_y = {};
    std::optional<std::size_t> group, label;
};

/// `head` may take names from the first row if a wish names a column by them. Throws Error: usage if there is no such column;
/// failed if the notation of numbers or dates is ambiguous.
TableColumns choose_columns(TableHead& head, const TableWish& wish, std::vector<Phrase>& notes);

/// The column of that name, with its unit or without. Throws Error(usage) if there is none.
std::size_t column_of(const TableHead& head, std::string_view option, const std::string& wanted);

/// Whether some of its first rows are numbers, or else dates.
bool holds_numbers(const TableHead& head, std::size_t column);
bool holds_dates(const TableHead& head, std::size_t column);

/// Takes column names from the first row if the wish names a column by them.
void name_by_first_row(TableHead& head, const TableWish& wish);

/// The notation of numbers and dates in these columns. Throws Error if it is ambiguous.
void settle_values(const TableHead& head, const TableWish& wish, const std::vector<ValueColumn*>& columns);

/// The name of an axis: for several columns, their unit, if all have the same; for one column, its name.
std::string name_of_all(const std::vector<ValueColumn>& columns);
/// "a, b and c": their names without units.
Phrase bare_names(const std::vector<ValueColumn>& columns);

/// Nothing for a gap. Throws Error(failed) with the line for anything else, and for values that no axis could show.
std::optional<double> value_in(const TableHead& head, const ValueColumn& column, std::size_t line, std::string_view cell);

}  // namespace tactics
