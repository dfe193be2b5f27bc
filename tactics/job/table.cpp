// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/table.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tactics/error.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kMost = 1e12;   // a number with more digits is no word to be felt
constexpr double kLeast = 1e-4;  // between the least and the largest: ticks are written to 1e-6

// Without its unit: "time (s)", "time".
std::string_view bare(std::string_view column) { return column.substr(0, std::min(column.find(" ("), column.size())); }

std::size_t column_of(const Csv& csv, std::string_view option, const std::string& wanted) {
    for (std::size_t i = 0; i < csv.columns.size(); ++i)
        if (csv.columns[i] == wanted) return i;
    for (std::size_t i = 0; i < csv.columns.size(); ++i)
        if (bare(csv.columns[i]) == wanted) return i;
    std::string all;
    for (const std::string& column : csv.columns) {
        if (all.size() > 400) {
            all += ", ...";
            break;
        }
        all += (all.empty() ? "\"" : ", \"") + beginning_of(column) + '"';
    }
    throw Error(Fault::usage, spelled(option),
                csv.name + " has no column \"" + beginning_of(wanted) + "\"" +
                    did_you_mean(wanted, {csv.columns.begin(), csv.columns.end()}) + "; it has " + all);
}

// A number as half of the world writes it; empty: it is none.
std::string with_point(std::string cell) {
    const auto comma = cell.find(',');
    if (comma == std::string::npos) return "";
    cell[comma] = '.';
    return parse_number(cell) ? cell : "";
}

// What a message says to do about a cell that is no number.
std::string how_to_write(const std::string& cell) {
    const std::string better = with_point(cell);
    return better.empty() ? "write it like 0.53, or leave it empty" : "write a point and no comma: " + beginning_of(better);
}

// Where the values of the table are.
struct Columns {
    std::size_t x = 0, y = 0;
    std::optional<std::size_t> group, label;
};

Columns choose(const Csv& csv, const TableWish& wish) {
    Columns choice;
    std::vector<std::size_t> taken;
    const auto named = [&](std::string_view option, const std::string& wanted) -> std::optional<std::size_t> {
        if (wanted.empty()) return std::nullopt;
        taken.push_back(column_of(csv, option, wanted));
        return taken.back();
    };
    choice.group = named("group", wish.group);
    choice.label = named("label", wish.label);
    const auto x = named("x", wish.x), y = named("y", wish.y);
    const auto next_of_numbers = [&](std::string_view option) {
        for (std::size_t i = 0; i < csv.columns.size(); ++i) {
            const auto number = [&](const CsvRow& row) { return parse_number(row.cells[i]).has_value(); };
            if (std::find(taken.begin(), taken.end(), i) != taken.end() || !std::any_of(csv.rows.begin(), csv.rows.end(), number))
                continue;
            taken.push_back(i);
            return i;
        }
        for (const CsvRow& row : csv.rows)
            for (const std::string& cell : row.cells)
                if (!with_point(cell).empty())
                    throw Error(Fault::failed, csv.name + ":" + std::to_string(row.line),
                                "\"" + beginning_of(cell) + "\" is no number; " + how_to_write(cell));
        throw Error(Fault::usage, spelled(option),
                    csv.name + " has no column of numbers for it; name one, or write numbers such as 0.53 below its name");
    };
    choice.x = x ? *x : next_of_numbers("x");
    choice.y = y ? *y : next_of_numbers("y");
    const std::string &across = csv.columns[choice.x], &up = csv.columns[choice.y];
    const auto is_number = [](const std::string& name) { return parse_number(name) || !with_point(name).empty(); };
    if (is_number(across) && is_number(up) && !(x && y))
        throw Error(Fault::failed, csv.name,
                    "its first line names the columns, and there is \"" + beginning_of(across) + "\" and \"" + beginning_of(up) +
                        "\", which are numbers; write a line of names above them, time (s),length (mm) for example, or name both "
                        "by " +
                        spelled("x") + " and " + spelled("y"));
    return choice;
}

// Nothing for an empty cell.
std::optional<double> number_in(const Csv& csv, const CsvRow& row, std::size_t column, bool logarithmic) {
    const std::string& cell = row.cells[column];
    if (cell.empty()) return std::nullopt;
    const std::string place = csv.name + ":" + std::to_string(row.line),
                      what = beginning_of(csv.columns[column]) + " is \"" + beginning_of(cell) + "\"";
    const auto number = parse_number(cell);
    if (!number) throw Error(Fault::failed, place, what + ", which is no number; " + how_to_write(cell));
    if (std::abs(*number) > kMost)
        throw Error(Fault::failed, place, what + ", too large to be written at an axis; write all in a larger unit");
    if (logarithmic && !(*number > 0))
        throw Error(Fault::failed, place,
                    what + ", and a logarithmic axis shows numbers over 0 only; leave the row out, or take an axis that is not");
    return number;
}

struct Range {
    double low = INFINITY, high = -INFINITY;
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

void check_range(const Csv& csv, std::size_t column, const Range& range, bool logarithmic) {
    const double least = logarithmic ? range.low : range.high - range.low;
    if (least != 0 && least < kLeast)
        throw Error(Fault::failed, csv.name,
                    "the numbers of " + beginning_of(csv.columns[column]) +
                        " are too small to be written at an axis; write them in a smaller unit");
}

Plot plot_of(const Csv& csv, const Columns& choice, const TableWish& wish, std::size_t& left_out) {
    Plot plot{std::string(bare(csv.columns[choice.y])) + " against " + std::string(bare(csv.columns[choice.x])),
              {csv.columns[choice.x], wish.log_x},
              {csv.columns[choice.y], wish.log_y},
              {},
              {}};
    std::vector<std::string> groups;
    Range across, up;
    for (const CsvRow& row : csv.rows) {
        const auto x = number_in(csv, row, choice.x, wish.log_x), y = number_in(csv, row, choice.y, wish.log_y);
        if (!x || !y) {
            ++left_out;
            continue;
        }
        across.take(*x);
        up.take(*y);
        const std::string name = choice.group ? row.cells[*choice.group] : "",
                          label = choice.label ? row.cells[*choice.label] : "";
        const auto at = static_cast<std::size_t>(std::find(groups.begin(), groups.end(), name) - groups.begin());
        const bool fresh = at == groups.size();
        if (fresh) {
            groups.push_back(name);
            plot.curves.push_back({name, {}});
        }
        if (wish.points && at > 1)
            throw Error(
                Fault::usage, spelled("points"),
                "a finger tells two groups of points, discs and rings, and " + csv.name + " has more; leave it out, or keep two");
        plot.curves[at].points.push_back({*x, *y});
        if (wish.points)
            plot.marks.push_back({label.empty() && fresh ? name : label, *x, *y, at == 0 ? PlotSymbol::disc : PlotSymbol::ring});
        else if (!label.empty())
            plot.marks.push_back({label, *x, *y});
    }
    if (groups.empty())
        throw Error(Fault::failed, csv.name,
                    "there is no row with numbers in " + beginning_of(csv.columns[choice.x]) + " and " +
                        beginning_of(csv.columns[choice.y]) + "; write some there, or name other columns by " + spelled("x") +
                        " and " + spelled("y"));
    check_range(csv, choice.x, across, wish.log_x);
    check_range(csv, choice.y, up, wish.log_y);
    if (wish.points) plot.curves.clear();
    // What is one point has no line: a ring of its name, unless it has a label.
    for (const PlotCurve& curve : plot.curves)
        if (curve.points.size() == 1 && std::none_of(plot.marks.begin(), plot.marks.end(), [&](const PlotMark& mark) {
                return mark.x == curve.points[0].x && mark.y == curve.points[0].y;
            }))
            plot.marks.push_back({curve.name, curve.points[0].x, curve.points[0].y, PlotSymbol::ring});
    std::erase_if(plot.curves, [](const PlotCurve& curve) { return curve.points.size() == 1; });
    return plot;
}

}  // namespace

Plot plot_of(const Csv& csv, const TableWish& wish, std::vector<std::string>& notes) {
    std::size_t left_out = 0;
    Plot plot = plot_of(csv, choose(csv, wish), wish, left_out);
    if (left_out > 0)
        notes.push_back(std::to_string(left_out) + (left_out == 1 ? " row has" : " rows have") + " no number for the chart and " +
                        (left_out == 1 ? "is" : "are") + " left out");
    return plot;
}

}  // namespace tactics
