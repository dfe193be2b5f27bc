// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/table_columns.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "tactics/error.h"
#include "tactics/text/named_unit.h"
#include "tactics/text/number.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kMost = 1e12;  // a number with more digits is no word to be felt

std::string shown(std::string_view cell) { return "\"" + beginning_of(to_line(cell)) + "\""; }

std::optional<std::size_t> find_column(const TableHead& head, const std::string& wanted) {
    for (std::size_t i = 0; i < head.columns.size(); ++i)
        if (head.columns[i] == wanted) return i;
    for (std::size_t i = 0; i < head.columns.size(); ++i)
        if (name_and_unit(head.columns[i]).name == wanted) return i;
    return std::nullopt;
}

}  // namespace

std::size_t column_of(const TableHead& head, std::string_view option, const std::string& wanted) {
    if (const auto found = find_column(head, wanted)) return *found;
    std::string all;
    for (const std::string& column : head.columns) {
        if (all.size() > 400) {
            all += ", ...";
            break;
        }
        all += (all.empty() ? "\"" : ", \"") + beginning_of(column) + '"';
    }
    throw Error(Fault::usage, spelled(option),
                phrase("{0} has no column \"{1}\"{2}; it has {3}", head.name, beginning_of(wanted),
                       did_you_mean(wanted, {head.columns.begin(), head.columns.end()}), all));
}

namespace {

// A number as half of the world writes it; empty: it is none.
std::string with_point(std::string_view cell) {
    const auto comma = cell.find(',');
    if (comma == std::string_view::npos || !number_in(cell, Decimal::comma)) return "";
    std::string text(cell);
    text[comma] = '.';
    return text;
}

bool is_date(std::string_view cell) {
    return read_date(cell, DateOrder::year_first).fault != DateFault::other || day_and_month(cell).has_value();
}

bool some_row(const TableHead& head, std::size_t column, bool (*is)(std::string_view)) {
    return std::any_of(head.rows.begin(), head.rows.end(), [&](const TableRow& row) { return is(row.cells[column]); });
}

}  // namespace

bool holds_numbers(const TableHead& head, std::size_t column) {
    return some_row(head, column, [](std::string_view cell) { return is_number(cell) || has_thousands(cell); });
}
bool holds_dates(const TableHead& head, std::size_t column) {
    return !holds_numbers(head, column) && some_row(head, column, is_date);
}

namespace {

// The order of days and months, as shown by the first rows.
DateOrder order_of(const TableHead& head, const ValueColumn& column) {
    const TableRow* some = nullptr;
    for (const TableRow& row : head.rows) {
        const auto parts = day_and_month(row.cells[column.at]);
        if (!parts) continue;
        some = &row;
        if (parts->first > 12 && parts->second <= 12) return DateOrder::day_first;
        if (parts->second > 12 && parts->first <= 12) return DateOrder::month_first;
    }
    if (some == nullptr) return DateOrder::year_first;
    throw Error(Fault::failed, place_of_row(head, some->line),
                phrase("is {0} day.month or month/day? No day in the first rows is over 12; say {1} DMY or {1} MDY, or write it "
                       "like 2024-02-29",
                       shown(some->cells[column.at]), spelled("dates")));
}

// Whether numbers have points or commas, by all of the first rows.
Decimal decimal_of(const TableHead& head, const std::vector<ValueColumn*>& columns) {
    const TableRow *point = nullptr, *comma = nullptr, *either = nullptr;
    std::string with_mark, comma_cell, either_cell;
    for (const TableRow& row : head.rows)
        for (const ValueColumn* column : columns) {
            const std::string& cell = row.cells[column->at];
            if (column->dates) continue;
            if (cell.find('.') != std::string::npos && number_in(cell, Decimal::point)) {
                point = &row;
                with_mark = cell;
            } else if (cell.find(',') != std::string::npos && number_in(cell, Decimal::comma)) {
                const TableRow*& found = has_thousands(cell) ? either : comma;
                (has_thousands(cell) ? either_cell : comma_cell) = cell;
                found = &row;
            }
        }
    if (point != nullptr && comma != nullptr)
        throw Error(Fault::failed, place_of_row(head, comma->line),
                    phrase("there is {0}, and {1} in line {2}; write all numbers with a point, or all with a comma",
                           shown(comma_cell), shown(with_mark), std::to_string(point->line)));
    if (comma != nullptr) return Decimal::comma;
    if (either != nullptr && point == nullptr)
        throw Error(Fault::failed, place_of_row(head, either->line),
                    phrase("{0} may be {1} or a whole number; say {2} comma, or write numbers without a mark between thousands",
                           shown(either_cell), with_point(either_cell), spelled("decimal")));
    return Decimal::point;
}

// The first columns of values in the order of the file, for what was not named.
class ColumnChoice {
public:
    ColumnChoice(const TableHead& head, std::vector<std::size_t> taken) : head_(head), taken_(std::move(taken)) {
        if (head.row_names) taken_.push_back(0);
    }

    std::optional<std::size_t> next() {
        for (std::size_t i = 0; i < head_.columns.size(); ++i) {
            if (std::find(taken_.begin(), taken_.end(), i) != taken_.end()) continue;
            if (!holds_numbers(head_, i) && !holds_dates(head_, i)) continue;
            taken_.push_back(i);
            return i;
        }
        return std::nullopt;
    }

private:
    const TableHead& head_;
    std::vector<std::size_t> taken_;
};

}  // namespace

void name_by_first_row(TableHead& head, const TableWish& wish) {
    if (head.named || head.rows.size() < 2) return;
    const std::vector<std::string>& first = head.rows.front().cells;
    std::vector<std::string> wanted{wish.x, wish.y, wish.z, wish.group, wish.label};
    for (const auto* more : {&wish.other_y, &wish.errors, &wish.lower, &wish.upper})
        wanted.insert(wanted.end(), more->begin(), more->end());
    for (const std::string& name : wanted)
        if (!name.empty() && !find_column(head, name) && std::find(first.begin(), first.end(), name) != first.end()) {
            head = named_by_first_row(std::move(head));
            return;
        }
}

namespace {

// A table of many columns is often meant as a curve for each.
void tell_left_out(const TableHead& head, std::size_t y, ColumnChoice& others, std::vector<Phrase>& notes) {
    constexpr std::size_t kNamed = 3;
    std::vector<Phrase> named;
    std::size_t count = 0;
    for (auto other = others.next(); other; other = others.next(), ++count)
        if (count < kNamed) named.push_back(beginning_of(head.columns[*other]));
    if (count == 0) return;
    Phrase names = row_of(named);
    if (count > kNamed) names = phrase("{0} and {1} more", std::move(names), std::to_string(count - kNamed));
    notes.push_back(
        phrase("of its columns of numbers {0} is shown, and not {1}; name another by {2}, or, for a curve each, name several",
               beginning_of(head.columns[y]), names, spelled("y")));
}

std::size_t different_cells(const TableHead& head, std::size_t column) {
    std::set<std::string_view> cells;
    for (const TableRow& row : head.rows) cells.insert(row.cells[column]);
    return cells.size();
}

// Each value of one column is there with each value of the other, but for a few that are missing: a grid that is written out.
bool is_grid(const TableHead& head, std::size_t x, std::size_t y) {
    const std::size_t across = different_cells(head, x), up = different_cells(head, y);
    return head.rows.size() > 4 && across > 1 && up > 1 && 2 * across * up <= 3 * head.rows.size();
}

// A curve of heights over a plane says nothing.
void hint_at_heights(const TableHead& head, std::size_t x, std::size_t y, ColumnChoice others, std::vector<Phrase>& notes) {
    const std::optional<std::size_t> z = others.next();
    if (!z) return;
    if (is_grid(head, x, y))
        notes.push_back(phrase("if {0} is the height over {1} and {2}, name it by {3}", beginning_of(head.columns[*z]),
                               beginning_of(head.columns[x]), beginning_of(head.columns[y]), spelled("z")));
    else if (!head.named && others.next())
        notes.push_back(phrase("if its rows are heights, use {0}", spelled("matrix")));
}

void check_names(const TableHead& head, const std::string& across, const std::string& up) {
    if (!head.named || !is_number(across) || !is_number(up)) return;
    throw Error(Fault::failed, head.name,
                phrase("its first line names the columns, and there is \"{0}\" and \"{1}\", which are numbers; write a line of "
                       "names above them, time (s),length (mm) for example, or name both by {2} and {3}",
                       beginning_of(across), beginning_of(up), spelled("x"), spelled("y")));
}

}  // namespace

void settle_values(const TableHead& head, const TableWish& wish, const std::vector<ValueColumn*>& columns) {
    for (ValueColumn* column : columns) {
        if (!holds_dates(head, column->at)) continue;
        column->dates = wish.dates ? *wish.dates : order_of(head, *column);
        if (column->logarithmic)
            throw Error(Fault::usage, spelled("log-" + column->wish),
                        phrase("{0} has dates, which are on no logarithmic axis", column->name));
    }
    const Decimal decimal = wish.decimal ? *wish.decimal : decimal_of(head, columns);
    for (ValueColumn* column : columns) column->decimal = decimal;
}

std::string name_of_all(const std::vector<ValueColumn>& columns) {
    if (columns.size() == 1) return columns[0].name;
    const std::string_view unit = name_and_unit(columns[0].name).unit;
    const bool same = std::all_of(columns.begin(), columns.end(),
                                  [&](const ValueColumn& column) { return name_and_unit(column.name).unit == unit; });
    return same ? std::string(unit) : "";
}

Phrase bare_names(const std::vector<ValueColumn>& columns) {
    std::vector<Phrase> names;
    for (const ValueColumn& column : columns) names.emplace_back(name_and_unit(column.name).name);
    return listed(names);
}

TableColumns choose_columns(TableHead& head, const TableWish& wish, std::vector<Phrase>& notes) {
    name_by_first_row(head, wish);
    TableColumns choice;
    std::vector<std::size_t> taken;
    const auto named = [&](std::string_view option, const std::string& wanted) -> std::optional<std::size_t> {
        if (wanted.empty()) return std::nullopt;
        taken.push_back(column_of(head, option, wanted));
        return taken.back();
    };
    choice.group = named("group", wish.group);
    choice.label = named("label", wish.label);
    auto x = named("x", wish.x), y = named("y", wish.y);
    const auto z = named("z", wish.z);
    const bool both = x && y;
    ColumnChoice others(head, taken);
    if (!x) x = others.next();
    if (wish.histogram) y = x;
    if (!y) y = others.next();
    const bool is_chosen = wish.y.empty() && y && !z && !wish.histogram;
    if (!x || (!y && (!wish.x.empty() || z)))
        throw Error(
            Fault::usage, spelled(x ? "y" : "x"),
            phrase("{0} has no column of numbers for it; name one, or write numbers such as 0.53 below its name", head.name));
    if (!y) {  // one column: against the number of the row
        y = x;
        x.reset();
        notes.push_back(phrase("there is one column of numbers, shown against the number of its row"));
    }
    if (x && !both && !wish.histogram) check_names(head, head.columns[*x], head.columns[*y]);
    if (!head.named)
        notes.push_back(
            head.columns.size() >= 4
                ? phrase("its first line has values and no names; the columns are called column 1, column 2 and so on")
            : head.columns.size() > 1
                ? phrase("its first line has values and no names; the columns are called {0}, y and so on", head.columns.front())
                : phrase("its first line has values and no names; the columns are called {0}", head.columns.front()));
    if (is_chosen) {
        const ColumnChoice more = others;
        tell_left_out(head, *y, others, notes);
        if (x) hint_at_heights(head, *x, *y, more, notes);
    }
    std::vector<ValueColumn*> values;
    if (x) {
        choice.x = ValueColumn{head.columns[*x], "x", *x, wish.log_x};
        values.push_back(&*choice.x);
    }
    choice.y = ValueColumn{head.columns[*y], "y", *y, wish.log_y};
    values.push_back(&choice.y);
    for (const std::string& name : wish.other_y) {
        const std::size_t at = column_of(head, "y", name);
        choice.other_y.push_back({head.columns[at], "y", at, wish.log_y});
    }
    for (ValueColumn& other : choice.other_y) values.push_back(&other);
    if (z) {
        choice.z = ValueColumn{head.columns[*z], "z", *z};
        values.push_back(&*choice.z);
    }
    settle_values(head, wish, values);
    return choice;
}

namespace {

[[noreturn]] void refuse(const TableHead& head, const ValueColumn& column, std::size_t line, std::string_view cell,
                         const Phrase& why) {
    throw Error(Fault::failed, place_of_row(head, line), phrase("{0} is {1}, {2}", beginning_of(column.name), shown(cell), why));
}

double date_in(const TableHead& head, const ValueColumn& column, std::size_t line, std::string_view cell) {
    const DateReading date = read_date(cell, *column.dates);
    if (date.fault == DateFault::none) return date.seconds;
    refuse(head, column, line, cell,
           date.fault == DateFault::impossible ? phrase("and there is no such day or time; mend it, or leave it empty")
           : date.fault == DateFault::old      ? phrase("and our calendar began on 15 October 1582; write years as numbers")
                                               : phrase("which is no date as those above it; write it like 2024-02-29"));
}

// What to do about what is no number.
Phrase how_to_write(const ValueColumn& column, std::string_view cell) {
    const std::string better = with_point(cell);
    if (is_infinity(cell)) return phrase("which no axis reaches; leave it empty");
    if (has_thousands(cell) && !(column.decimal == Decimal::point && cell.find(',') == std::string_view::npos)) {
        std::string bare;
        const auto fraction = cell.find_last_of(",.");
        const bool two_marks = cell.find(',') != std::string_view::npos && cell.find('.') != std::string_view::npos;
        for (std::size_t i = 0; i < cell.size(); ++i) {
            if (cell[i] != ',' && cell[i] != '.' && cell[i] != '\'')
                bare += cell[i];
            else if (two_marks && i == fraction)
                bare += column.decimal == Decimal::comma ? ',' : '.';
        }
        return phrase("with a mark between thousands; write it without: {0}", beginning_of(bare));
    }
    if (column.decimal == Decimal::comma && parse_number(cell))
        return phrase("with a point, and others have a decimal comma; write all of them in one way");
    return better.empty() ? phrase("which is no number; write it like 0.53, or leave it empty")
                          : phrase("which is no number; write a point and no comma: {0}", beginning_of(better));
}

}  // namespace

std::optional<double> value_in(const TableHead& head, const ValueColumn& column, std::size_t line, std::string_view cell) {
    if (column.dates) {
        if (is_gap(cell)) return std::nullopt;
        return date_in(head, column, line, cell);
    }
    const auto number = number_in(cell, column.decimal);
    if (!number) {
        if (is_gap(cell)) return std::nullopt;
        refuse(head, column, line, cell, how_to_write(column, cell));
    }
    if (std::abs(*number) > kMost)
        refuse(head, column, line, cell, phrase("too large to be written at an axis; write all in a larger unit"));
    if (column.logarithmic && !(*number > 0))
        refuse(head, column, line, cell,
               phrase("and a logarithmic axis shows numbers over 0 only; leave the row out, or take an axis that is not"));
    return number;
}

}  // namespace tactics
