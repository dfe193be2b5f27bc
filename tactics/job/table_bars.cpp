// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/table_bars.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "tactics/error.h"
#include "tactics/job/table_columns.h"
#include "tactics/readers/read_table.h"
#include "tactics/text/named_unit.h"
#include "tactics/text/number.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kLeastValue = 1e-4;  // of the largest: ticks are written to 1e-6
constexpr double kNone = NAN;

std::string in_quotes(const std::string& text) { return "\"" + beginning_of(text) + "\""; }

struct BarColumns {
    std::optional<std::size_t> category;  // nothing: the number of the row
    std::vector<ValueColumn> values;
    std::vector<ValueColumn> lower, upper;  // or `lower` alone: how far each value is off
    std::optional<std::size_t> group;
};

// The category is the first column of words, or else the first of all.
std::optional<std::size_t> category_of(const TableHead& head, const TableWish& wish, const std::optional<std::size_t>& group) {
    if (!wish.x.empty()) return column_of(head, "x", wish.x);
    if (head.row_names) return 0;
    for (std::size_t i = 0; i < head.columns.size(); ++i)
        if (i != group && !holds_numbers(head, i)) return i;
    return head.columns.size() > 1 ? std::optional<std::size_t>(0) : std::nullopt;
}

std::vector<ValueColumn> named_columns(const TableHead& head, std::string_view option, const std::vector<std::string>& names) {
    std::vector<ValueColumn> columns;
    for (const std::string& name : names) {
        const std::size_t at = column_of(head, option, name);
        columns.push_back({head.columns[at], std::string(option), at});
    }
    return columns;
}

void check_counts(const TableWish& wish, const BarColumns& columns) {
    const auto refuse = [](std::string_view option, const Phrase& why) { throw Error(Fault::usage, spelled(option), why); };
    if (wish.lower.size() != wish.upper.size())
        refuse(wish.lower.size() < wish.upper.size() ? "lower" : "upper",
               phrase("the least and the largest value go together; name as many columns by {0} as by {1}", spelled("lower"),
                      spelled("upper")));
    if (!wish.errors.empty() && !wish.lower.empty())
        refuse("error", phrase("errors stand in one column, or their ends in two; leave out {0}, or {1} and {2}",
                               spelled("error"), spelled("lower"), spelled("upper")));
    if (!columns.lower.empty() && columns.lower.size() != columns.values.size())
        refuse(wish.errors.empty() ? "lower" : "error",
               phrase("there are {0} columns of values and {1} for their errors; name one for each",
                      std::to_string(columns.values.size()), std::to_string(columns.lower.size())));
    if (!columns.lower.empty() && *wish.bars != BarKind::grouped)
        refuse("error", phrase("errors stand on bars that begin at 0; take {0} grouped", spelled("bars")));
    if (columns.group && columns.values.size() > 1)
        refuse("group", phrase("groups are of one column; name it by {0}", spelled("y")));
    if (columns.values.size() > kMostSeries)
        refuse("y", phrase("a finger tells {0} textures, and there are {1} columns; name at most {0}",
                           std::to_string(kMostSeries), std::to_string(columns.values.size())));
    if (*wish.bars == BarKind::pie && (columns.group || columns.values.size() > 1))
        refuse("bars", phrase("a pie shows the shares of one column; name it by {0}", spelled("y")));
}

BarColumns choose_bar_columns(TableHead& head, const TableWish& wish, std::vector<Phrase>& notes) {
    name_by_first_row(head, wish);
    BarColumns columns;
    if (!wish.group.empty()) columns.group = column_of(head, "group", wish.group);
    columns.category = category_of(head, wish, columns.group);
    std::vector<std::string> names;
    if (!wish.y.empty()) names.push_back(wish.y);
    names.insert(names.end(), wish.other_y.begin(), wish.other_y.end());
    columns.values = named_columns(head, "y", names);
    columns.lower = named_columns(head, wish.errors.empty() ? "lower" : "error", wish.errors.empty() ? wish.lower : wish.errors);
    columns.upper = named_columns(head, "upper", wish.upper);
    if (names.empty()) {
        const auto is_error = [&](std::size_t i) {
            const auto its = [i](const ValueColumn& column) { return column.at == i; };
            return std::any_of(columns.lower.begin(), columns.lower.end(), its) ||
                   std::any_of(columns.upper.begin(), columns.upper.end(), its);
        };
        for (std::size_t i = 0; i < head.columns.size(); ++i)
            if (i != columns.category && i != columns.group && !is_error(i) && holds_numbers(head, i))
                columns.values.push_back({head.columns[i], "y", i});
        if (columns.values.empty())
            throw Error(
                Fault::usage, spelled("y"),
                phrase("{0} has no column of numbers for it; name one, or write numbers such as 0.53 below its name", head.name));
        const std::size_t most = columns.group || *wish.bars == BarKind::pie ? 1 : kMostSeries;
        if (columns.values.size() > most) {
            notes.push_back(most == 1
                                ? phrase("of its {0} columns of numbers {1} is shown; name others by {2}",
                                         std::to_string(columns.values.size()), in_quotes(columns.values[0].name), spelled("y"))
                                : phrase("of its {0} columns of numbers the first five are shown; name others by {1}",
                                         std::to_string(columns.values.size()), spelled("y")));
            columns.values.resize(most);
        }
    }
    check_counts(wish, columns);
    std::vector<ValueColumn*> all;
    for (auto* some : {&columns.values, &columns.lower, &columns.upper})
        for (ValueColumn& column : *some) all.push_back(&column);
    settle_values(head, wish, all);
    for (const ValueColumn* column : all)
        if (column->dates)
            throw Error(Fault::usage, spelled(column->wish),
                        phrase("{0} has dates, and a bar shows a number", beginning_of(column->name)));
    return columns;
}

// Rows become bars as they come.
class BarTable {
public:
    BarTable(const TableHead& head, const BarColumns& columns, const std::string& language)
        : head_(head), columns_(columns), language_(language) {
        if (columns.category) wanted_.push_back(*columns.category);
        if (columns.group) wanted_.push_back(*columns.group);
        for (const auto* some : {&columns.values, &columns.lower, &columns.upper})
            for (const ValueColumn& column : *some) wanted_.push_back(column.at);
        if (columns.group) return;
        for (const ValueColumn& column : columns.values)
            bars.series.push_back({columns.values.size() > 1 ? column.name : "", {}});
    }

    std::span<const std::size_t> wanted() const { return wanted_; }

    void take(std::size_t line, std::span<const std::string_view> cells) {
        ++rows_;
        std::size_t at = 0;
        std::string name = columns_.category ? to_line(cells[at++]) : std::to_string(rows_);
        const std::string group = columns_.group ? to_line(cells[at++]) : "";
        std::vector<std::optional<double>> values;
        for (const auto* some : {&columns_.values, &columns_.lower, &columns_.upper})
            for (const ValueColumn& column : *some) values.push_back(value_in(head_, column, line, cells[at++]));
        const std::size_t count = columns_.values.size();
        const bool known = std::any_of(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count),
                                       [](const auto& value) { return value.has_value(); });
        if (name.empty() && !known) return;
        if (name.empty()) name = phrase("row {0}", std::to_string(rows_)).in(language_);
        const std::size_t category = category_named(name, line);
        const std::size_t first = columns_.group ? series_named(group) : 0;
        for (std::size_t k = 0; k < count; ++k) {
            PlotSeries& series = bars.series[first + k];
            fill(series);
            if (taken_[first + k].size() <= category) taken_[first + k].resize(category + 1);
            if (taken_[first + k][category])
                throw Error(Fault::failed, place_of_row(head_, line),
                            group.empty()
                                ? phrase("{0} stands there for the second time; a column that tells its rows apart can be named "
                                         "by {1}; leave one of them out, or add them up",
                                         in_quotes(name), spelled("group"))
                                : phrase("{0} stands there for the second time in {1}; leave one of them out, or add them up",
                                         in_quotes(name), in_quotes(group)));
            taken_[first + k][category] = true;
            set(series, category, values, k, line);
        }
    }

    void fill_all() {
        for (PlotSeries& series : bars.series) fill(series);
    }

    PlotBars bars;

private:
    void fill(PlotSeries& series) const {
        series.values.resize(bars.categories.size(), kNone);
        if (!columns_.lower.empty()) series.errors.resize(bars.categories.size(), {kNone, kNone});
    }

    void set(PlotSeries& series, std::size_t category, const std::vector<std::optional<double>>& values, std::size_t k,
             std::size_t line) const {
        const std::size_t count = columns_.values.size();
        series.values[category] = values[k].value_or(kNone);
        if (columns_.lower.empty() || !values[k] || !values[count + k]) return;
        const double value = *values[k], first = *values[count + k];
        if (columns_.upper.empty()) {
            if (first < 0)
                throw Error(Fault::failed, place_of_row(head_, line),
                            phrase("{0} is {1}, and an error is no less than 0; mend it, or leave it empty",
                                   beginning_of(columns_.lower[k].name), to_text(first)));
            series.errors[category] = {value - first, value + first};
            return;
        }
        if (!values[2 * count + k]) return;
        const double last = *values[2 * count + k];
        if (first > value || last < value)
            throw Error(Fault::failed, place_of_row(head_, line),
                        phrase("{0} is {1}, which is not between {2} and {3}; mend it, or leave one of these empty",
                               beginning_of(columns_.values[k].name), to_text(value), to_text(first), to_text(last)));
        series.errors[category] = {first, last};
    }

    std::size_t category_named(const std::string& name, std::size_t line) {
        const auto [known, fresh] = categories_.try_emplace(name, bars.categories.size());
        if (!fresh) return known->second;
        if (bars.categories.size() == kMostCategories)
            throw Error(Fault::failed, place_of_row(head_, line),
                        phrase("there are more than {0} bars, and no page has room for them; keep fewer rows, or show how often "
                               "values occur by {1}",
                               std::to_string(kMostCategories), spelled("histogram")));
        bars.categories.push_back(name);
        return known->second;
    }

    std::size_t series_named(const std::string& name) {
        for (std::size_t i = 0; i < bars.series.size(); ++i)
            if (bars.series[i].name == name) return i;
        if (bars.series.size() == kMostSeries)
            throw Error(Fault::usage, spelled("group"),
                        phrase("a finger tells {0} textures, and {1} has more groups; keep the rows of {0}",
                               std::to_string(kMostSeries), head_.name));
        bars.series.push_back({name, {}});
        return bars.series.size() - 1;
    }

    const TableHead& head_;
    const BarColumns& columns_;
    std::vector<std::size_t> wanted_;
    std::unordered_map<std::string, std::size_t> categories_;
    std::vector<bool> taken_[kMostSeries];
    std::string language_;  // of names that rows have not
    std::size_t rows_ = 0;
};

void check_values(const TableHead& head, const PlotBars& bars) {
    double most = 0;
    bool any = false;
    for (const PlotSeries& series : bars.series)
        for (const double value : series.values)
            if (!std::isnan(value)) {
                any = true;
                most = std::max(most, std::abs(value));
            }
    if (!any)
        throw Error(Fault::failed, head.name,
                    phrase("there is no row with a number for a bar; name other columns by {0}", spelled("y")));
    if (most > 0 && most < kLeastValue)
        throw Error(Fault::failed, head.name,
                    phrase("its numbers are too small to be written at an axis; write them in a smaller unit"));
}

void take_shares(const TableHead& head, PlotBars& bars, std::vector<Phrase>& notes) {
    double sum = 0;
    for (std::size_t i = 0; i < bars.categories.size(); ++i) {
        const double value = bars.series[0].values[i];
        if (value < 0)
            throw Error(Fault::failed, head.name,
                        phrase("{0} is less than 0, which is no share of a whole; take {1} grouped",
                               in_quotes(bars.categories[i]), spelled("bars")));
        if (!std::isnan(value)) sum += value;
    }
    if (!(sum > 0))
        throw Error(Fault::failed, head.name,
                    phrase("its numbers add up to 0, so there are no shares; take {0} grouped", spelled("bars")));
    for (double& value : bars.series[0].values) value *= 100 / sum;
    notes.push_back(
        phrase("a finger compares lengths and not angles, so the pie is drawn as bars: shares in percent of {0}", to_text(sum)));
}

Phrase title_of(const BarColumns& columns, const std::string& category, bool shares) {
    const Phrase values = bare_names(columns.values);
    if (shares) return category.empty() ? phrase("Shares of {0}", values) : phrase("Shares of {0} by {1}", values, category);
    return category.empty() ? values : phrase("{0} by {1}", values, category);
}

}  // namespace

Plot bars_plot(Source& source, TableHead& head, const TableWish& wish, std::vector<Phrase>& notes) {
    const BarColumns columns = choose_bar_columns(head, wish, notes);
    BarTable table(head, columns, wish.language);
    read_rows(source, head, table.wanted(),
              [&](std::size_t line, std::span<const std::string_view> cells, bool) { table.take(line, cells); });
    table.fill_all();
    Plot plot;
    plot.bars = std::move(table.bars);
    plot.bars->stacked = *wish.bars == BarKind::stacked;
    plot.bars->way = wish.bar_way;
    check_values(head, *plot.bars);
    const bool shares = *wish.bars == BarKind::pie;
    if (shares) take_shares(head, *plot.bars, notes);
    const std::string row = phrase("row").in(wish.language);
    plot.x.name = columns.category ? head.columns[*columns.category] : row;
    plot.y.name = shares ? phrase("percent").in(wish.language) : name_of_all(columns.values);
    plot.y.comma = wish.written.value_or(columns.values[0].decimal) == Decimal::comma;
    plot.title = title_of(columns, columns.category ? bare_name(plot.x.name) : row, shares).in(wish.language);
    return plot;
}

}  // namespace tactics
