// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/table_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "tactics/error.h"
#include "tactics/readers/read_table.h"
#include "tactics/text/named_unit.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostSurfaceHeights = kMostTableRows;  // of a surface: 160 MB

std::vector<double> once_each(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t place_in(const std::vector<double>& sorted, double value) {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

void tell_unknown(const std::vector<double>& z, std::vector<Phrase>& notes) {
    const auto unknown = std::count_if(z.begin(), z.end(), [](double height) { return std::isnan(height); });
    if (unknown > 0)
        notes.push_back(phrase("nothing is known of {0} of the {1} places of the surface", std::to_string(unknown),
                               std::to_string(z.size())));
}

// Rising or falling, two at least.
bool is_monotone(const std::vector<double>& values) {
    if (values.size() < 2) return false;
    const bool rising = values[1] > values[0];
    for (std::size_t i = 1; i < values.size(); ++i)
        if (rising ? !(values[i] > values[i - 1]) : !(values[i] < values[i - 1])) return false;
    return true;
}

// All numbers, with that mark; nothing if one is none.
std::optional<std::vector<double>> numbers_of(std::span<const std::string> cells, Decimal decimal) {
    std::vector<double> numbers;
    for (const std::string& cell : cells) {
        const auto number = number_in(cell, decimal);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

// The possible first row of the matrix: names, or the first row itself.
const std::vector<std::string>& first_row(const TableHead& head) { return head.named ? head.columns : head.rows.front().cells; }

Decimal matrix_decimal(const TableHead& head, const TableWish& wish) {
    if (wish.decimal) return *wish.decimal;
    const auto with_comma = [](const std::string& cell) {
        return cell.find(',') != std::string::npos && number_in(cell, Decimal::comma).has_value();
    };
    const auto with_point = [](const std::string& cell) {
        return cell.find('.') != std::string::npos && number_in(cell, Decimal::point).has_value();
    };
    const auto some = [&](const auto& has) {
        return std::any_of(head.rows.begin(), head.rows.end(),
                           [&](const TableRow& row) { return std::any_of(row.cells.begin(), row.cells.end(), has); });
    };
    if (!some(with_comma)) return Decimal::point;
    if (some(with_point))
        throw Error(
            Fault::failed, head.name,
            phrase(
                "some of its numbers have a point and some a comma; write all of them in one way, or say {0} point or {0} comma",
                spelled("decimal")));
    return Decimal::comma;
}

struct Borders {
    bool there = false;          // the first column is y
    std::vector<double> across;  // x; empty: counted
    bool in_rows = false;        // the first row of the table is x and no heights
};

Borders borders_of(const TableHead& head, Decimal decimal, bool asked) {
    const std::vector<std::string>& first = first_row(head);
    if (first.size() < 3 || head.rows.empty()) return {};
    const auto across = numbers_of(std::span(first).subspan(1), decimal);
    if (!across || !is_monotone(*across)) return {};
    std::vector<double> up;
    for (std::size_t i = head.named ? 0 : 1; i < head.rows.size(); ++i) {
        const auto number = number_in(head.rows[i].cells.front(), decimal);
        if (!number) return {};
        up.push_back(*number);
    }
    if (!is_monotone(up)) return {};
    const auto corner = number_in(first.front(), decimal);
    const bool counts = asked && corner && *corner == static_cast<double>(first.size() - 1);
    if (corner && !counts) return {};
    return {true, *across, !head.named};
}

}  // namespace

std::optional<PlotSurface> surface_of(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z) {
    PlotSurface surface{"", once_each(x), once_each(y), {}};
    const std::size_t columns = surface.x.size(), rows = surface.y.size();
    if (columns < 2 || rows < 2 || columns > kMostSurfaceHeights / rows || columns * rows > 2 * x.size()) return std::nullopt;
    surface.z.assign(columns * rows, kUnknown);
    std::vector<bool> taken(columns * rows);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t at = place_in(surface.y, y[i]) * columns + place_in(surface.x, x[i]);
        if (taken[at]) return std::nullopt;
        taken[at] = true;
        surface.z[at] = z[i];
    }
    return surface;
}

Plot spatial_plot(Source& source, const TableHead& head, const TableColumns& columns, const TableWish& wish,
                  std::vector<Phrase>& notes) {
    const std::size_t wanted[] = {columns.x->at, columns.y.at, columns.z->at};
    std::vector<double> x, y, z;
    for (auto* values : {&x, &y, &z}) values->reserve(std::min(head.rows_expected, kMostTableRows));
    std::size_t left_out = 0;
    read_rows(source, head, wanted, [&](std::size_t line, std::span<const std::string_view> cells, bool) {
        const auto across = value_in(head, *columns.x, line, cells[0]), up = value_in(head, columns.y, line, cells[1]);
        const auto height = value_in(head, *columns.z, line, cells[2]);
        if (!across || !up) {
            ++left_out;
            return;
        }
        x.push_back(*across);
        y.push_back(*up);
        z.push_back(height.value_or(kUnknown));
    });
    Plot plot;
    plot.title = phrase("{0} over {1} and {2}", bare_name(columns.z->name), bare_name(columns.x->name), bare_name(columns.y.name))
                     .in(wish.language);
    plot.x = {columns.x->name, columns.x->logarithmic, columns.x->dates.has_value()};
    plot.y = {columns.y.name, columns.y.logarithmic, columns.y.dates.has_value()};
    plot.z = {columns.z->name, false, columns.z->dates.has_value()};
    plot.x.comma = plot.y.comma = plot.z.comma = wish.written.value_or(columns.y.decimal) == Decimal::comma;
    if (auto surface = surface_of(x, y, z)) {
        tell_unknown(surface->z, notes);
        plot.surfaces.push_back(std::move(*surface));
    } else {
        plot.spatial = true;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (std::isnan(z[i])) {
                ++left_out;
                continue;
            }
            if (plot.marks.size() == kMostTableMarks)
                throw Error(Fault::failed, head.name,
                            phrase("there are more than {0} points, and they are no grid, with each x and y once; keep every "
                                   "tenth or hundredth row",
                                   std::to_string(kMostTableMarks)));
            plot.marks.push_back({"", x[i], y[i], PlotSymbol::disc, z[i]});
        }
    }
    if (left_out > 0)
        notes.push_back(phrases(left_out, "{0} row has no number for the chart and is left out",
                                "{0} rows have no number for the chart and are left out"));
    if (plot.surfaces.empty() && plot.marks.empty())
        throw Error(Fault::failed, head.name, phrase("there is no row with numbers in all three columns; write some there"));
    return plot;
}

bool is_matrix(const TableHead& head) {
    if (head.form == TableForm::heights) return true;
    if (head.form != TableForm::lines) return false;
    return borders_of(head, Decimal::point, false).there || borders_of(head, Decimal::comma, false).there;
}

namespace {

void turn(PlotSurface& surface) {
    const std::size_t columns = surface.x.size(), rows = surface.y.size();
    if (surface.x.back() < surface.x.front()) {
        std::reverse(surface.x.begin(), surface.x.end());
        for (std::size_t row = 0; row < rows; ++row)
            std::reverse(surface.z.begin() + static_cast<std::ptrdiff_t>(row * columns),
                         surface.z.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns));
    }
    if (surface.y.back() < surface.y.front()) {
        std::reverse(surface.y.begin(), surface.y.end());
        for (std::size_t row = 0; row < rows / 2; ++row)
            std::swap_ranges(surface.z.begin() + static_cast<std::ptrdiff_t>(row * columns),
                             surface.z.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns),
                             surface.z.begin() + static_cast<std::ptrdiff_t>((rows - 1 - row) * columns));
    }
}

void check_sides(const TableHead& head, const PlotSurface& surface) {
    if (surface.x.size() < 2 || surface.y.size() < 2)
        throw Error(Fault::failed, head.name, phrase("a surface has two rows and two columns at least, and this has fewer"));
    if (surface.z.size() != surface.x.size() * surface.y.size())
        throw Error(Fault::failed, head.name,
                    phrase("z has {0} heights for {1} of x and {2} of y; give one for each pair",
                           std::to_string(surface.z.size()), std::to_string(surface.x.size()), std::to_string(surface.y.size())));
    if (!is_monotone(surface.x) || !is_monotone(surface.y))
        throw Error(Fault::failed, head.name, phrase("x and y of a surface rise or fall all the way; sort them"));
}

}  // namespace

Plot matrix_plot(Source& source, const TableHead& head, const TableWish& wish, std::vector<Phrase>& notes) {
    const Decimal decimal = matrix_decimal(head, wish);
    const bool heights = head.form == TableForm::heights;
    const Borders borders = heights ? Borders{} : borders_of(head, decimal, wish.matrix);
    PlotSurface surface{"", heights ? head.across : borders.across, heights ? head.up : std::vector<double>{}, {}};
    std::vector<std::size_t> wanted(heights ? 0 : head.columns.size());
    std::iota(wanted.begin(), wanted.end(), std::size_t{0});
    bool first = true;
    std::size_t rows = 0;
    read_rows(source, head, wanted, [&](std::size_t line, std::span<const std::string_view> cells, bool) {
        if (std::exchange(first, false) && borders.in_rows) return;
        ++rows;
        const std::size_t begin = borders.there ? 1 : 0;
        const ValueColumn column{"the height", "z", 0, false, {}, decimal};
        if (borders.there) {
            const auto up = value_in(head, {"y", "y", 0, false, {}, decimal}, line, cells.front());
            surface.y.push_back(up.value_or(kUnknown));
        }
        if (surface.z.size() + cells.size() > kMostSurfaceHeights)
            throw Error(
                Fault::failed, head.name,
                phrase("there are more than {0} heights; keep every second row and column", std::to_string(kMostSurfaceHeights)));
        if (heights && !surface.x.empty() && cells.size() != surface.x.size())
            throw Error(Fault::failed, head.name + ":" + std::to_string(line),
                        phrase("this row of z has {0} heights for {1} of x; write null for gaps", std::to_string(cells.size()),
                               std::to_string(surface.x.size())));
        if (surface.x.empty())
            for (std::size_t i = begin; i < cells.size(); ++i) surface.x.push_back(static_cast<double>(i - begin + 1));
        for (std::size_t i = begin; i < cells.size(); ++i)
            surface.z.push_back(value_in(head, column, line, cells[i]).value_or(kUnknown));
    });
    if (surface.y.empty())
        for (std::size_t i = 1; i <= rows; ++i) surface.y.push_back(static_cast<double>(i));
    check_sides(head, surface);
    turn(surface);
    tell_unknown(surface.z, notes);
    if (!wish.matrix && !heights)
        notes.push_back(phrase(
            "its first row and column are numbers, so it is taken as a matrix of heights; {0} and {1} name columns of a curve",
            spelled("x"), spelled("y")));
    Plot plot;
    plot.title = phrase("Heights").in(wish.language);
    plot.x = {borders.there || heights ? "x" : phrase("column").in(wish.language)};
    plot.y = {borders.there || heights ? "y" : phrase("row").in(wish.language)};
    plot.z = {"z"};
    plot.x.comma = plot.y.comma = plot.z.comma = wish.written.value_or(decimal) == Decimal::comma;
    plot.surfaces.push_back(std::move(surface));
    return plot;
}

}  // namespace tactics
