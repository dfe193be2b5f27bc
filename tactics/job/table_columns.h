// SPDX-License-Identifier: Apache-2.0
// Which columns of a table are wanted, and how what stands in them is read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/job/table_wish.h"
#include "tactics/readers/table.h"

namespace tactics {

/// A column of numbers or of dates.
struct ValueColumn {
    std::string name;    ///< with its unit
    std::string wish;    ///< that names it: "x"
    std::size_t at = 0;  ///< which of the table's
    bool logarithmic = false;
    std::optional<DateOrder> dates = {};  ///< nothing: numbers
    Decimal decimal = Decimal::point;
};

struct TableColumns {
    std::optional<ValueColumn> x;  ///< nothing: the number of the row, from 1
    ValueColumn y;
    std::optional<ValueColumn> z;
    std::optional<std::size_t> group, label;
};

/// `head` may be given names by its first row if a wish names a column so. Throws Error: usage if there is no such column; failed
/// if it is not clear how numbers or dates are meant.
TableColumns choose_columns(TableHead& head, const TableWish& wish, std::vector<std::string>& notes);

/// Nothing for a gap. Throws Error(failed) with the line for what is neither, and what no axis could show.
std::optional<double> value_in(const TableHead& head, const ValueColumn& column, std::size_t line, std::string_view cell);

}  // namespace tactics
