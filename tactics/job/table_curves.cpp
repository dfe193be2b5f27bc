// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/table_curves.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "tactics/error.h"
#include "tactics/job/table_histogram.h"
#include "tactics/readers/read_table.h"
#include "tactics/text/named_unit.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kLeast = 1e-4;  // between the least and the largest: ticks are written to 1e-6

struct Range {
    double low = INFINITY, high = -INFINITY;
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

void check_range(const TableHead& head, const ValueColumn& column, const Range& range) {
    const double least = column.logarithmic ? range.low : range.high - range.low;
    if (least != 0 && least < kLeast)
        throw Error(Fault::failed, head.name,
                    phrase("the numbers of {0} are too small to be written at an axis; write them in a smaller unit",
                           beginning_of(column.name)));
}

void tell_left_out(std::size_t count, std::vector<Phrase>& notes) {
    if (count > 0)
        notes.push_back(phrases(count, "{0} row has no number for the chart and is left out",
                                "{0} rows have no number for the chart and are left out"));
}

// Rows become curves and marks as they come.
class CurveTable {
public:
    CurveTable(const TableHead& head, const TableColumns& columns, const TableWish& wish)
        : head_(head), columns_(columns), wish_(wish) {
        if (columns.x) wanted_.push_back(columns.x->at);
        ups_.push_back(columns.y);
        ups_.insert(ups_.end(), columns.other_y.begin(), columns.other_y.end());
        for (const ValueColumn& up : ups_) {
            if (std::find(wanted_.begin() + (columns.x ? 1 : 0), wanted_.end(), up.at) != wanted_.end())
                throw Error(Fault::usage, spelled("y"),
                            phrase("{0} is named twice; name each column once", beginning_of(up.name)));
            wanted_.push_back(up.at);
            if (up.dates.has_value() != columns.y.dates.has_value())
                throw Error(Fault::usage, spelled("y"),
                            phrase("numbers and dates have no axis in common; name columns of one kind"));
        }
        if (columns.group) wanted_.push_back(*columns.group);
        if (columns.label) wanted_.push_back(*columns.label);
        const std::string across = columns.x ? columns.x->name : phrase("row").in(wish.language);
        plot_.title = phrase("{0} against {1}", bare_names(ups_), bare_name(across)).in(wish.language);
        const bool comma = wish.written.value_or(columns.y.decimal) == Decimal::comma;
        plot_.x = {across, columns.x && columns.x->logarithmic, columns.x && columns.x->dates.has_value(), false, comma};
        plot_.y = {name_of_all(ups_), columns.y.logarithmic, columns.y.dates.has_value(), false, comma};
    }

    std::span<const std::size_t> wanted() const { return wanted_; }

    void take(std::size_t line, std::span<const std::string_view> cells, bool apart) {
        ++rows_;
        std::size_t at = 0;
        std::optional<double> x = static_cast<double>(rows_);
        if (columns_.x) x = value_in(head_, *columns_.x, line, cells[at++]);
        if (ups_.size() == 1) {
            const auto y = value_in(head_, ups_[0], line, cells[at++]);
            if (!x || (!y && wish_.points)) return leave_out();
            Group& group = columns_.group ? group_of(cells[at++]) : group_of({});
            return take_value(group, *x, y, apart, columns_.label ? to_line(cells[at]) : "");
        }
        if (!x) return leave_out();
        for (const ValueColumn& up : ups_) take_value(group_of(up.name), *x, value_in(head_, up, line, cells[at++]), apart, "");
    }

    Plot plot(std::vector<Phrase>& notes) {
        if (!(across_.low <= across_.high))
            throw Error(
                Fault::failed, head_.name,
                phrase("there is no row with numbers in {0} and {1}; write some there, or name other columns by {2} and {3}",
                       beginning_of(plot_.x.name), beginning_of(plot_.y.name), spelled("x"), spelled("y")));
        if (columns_.x) check_range(head_, *columns_.x, across_);
        check_range(head_, columns_.y, up_);
        for (Group& group : groups_) {
            if (group.points == 0 || wish_.points) continue;
            mark_lone_points(group);
            // A path turns now and then; of rows in any order two of three are turns.
            if (2 * group.turns > group.points) turns_ = std::max(turns_, group.turns);
            if (!group.still) plot_.curves.push_back(std::move(group.curve));
        }
        tell_left_out(left_out_, notes);
        if (turns_ > 0)
            notes.push_back(phrase(
                "rows are joined in their order, and {0} changes direction {1} times; unless that is meant, sort the rows by it, "
                "or use {2}",
                beginning_of(plot_.x.name), numeral(static_cast<double>(turns_)), spelled("points")));
        if (gaps_ > 0)
            notes.push_back(ups_.size() > 1
                                ? phrases(gaps_, "{0} row has no number in one of the columns; the curve has a gap there",
                                          "{0} rows have no number in one of the columns; the curve has a gap there")
                                : phrases(gaps_, "{0} row has no number in {1}; the curve has a gap there",
                                          "{0} rows have no number in {1}; the curve has a gap there",
                                          beginning_of(plot_.y.name)));
        return std::move(plot_);
    }

private:
    struct Group {
        PlotCurve curve;
        std::size_t points = 0, turns = 0;
        double way = 0;      // from the last point but one to the last, from left to right
        bool apart = false;  // no line leads to the next point
        bool still = true;   // all points are one
    };

    void leave_out() { ++left_out_; }

    void take_value(Group& group, double x, std::optional<double> y, bool apart, const std::string& label) {
        group.apart = group.apart || apart || !y;
        if (!y) {
            ++gaps_;
            return;
        }
        across_.take(x);
        up_.take(*y);
        if (wish_.points) {
            const auto index = static_cast<std::size_t>(&group - groups_.data());
            add_mark({label.empty() && group.points++ == 0 ? group.curve.name : label, x, *y,
                      index == 0 ? PlotSymbol::disc : PlotSymbol::ring});
            return;
        }
        if (!label.empty()) add_mark({label, x, *y});
        add_point(group, {x, *y});
    }

    Group& group_of(std::string_view cell) {
        if (!groups_.empty() && groups_[last_].curve.name == cell) return groups_[last_];
        const std::string name = to_line(cell);
        const auto [known, fresh] = indices_.try_emplace(name, groups_.size());
        last_ = known->second;
        if (!fresh) return groups_[last_];
        if (wish_.points && last_ > 1)
            throw Error(
                Fault::usage, spelled("points"),
                phrase("a finger tells two groups of points, discs and rings, and {0} has more; leave it out, or keep two",
                       head_.name));
        if (last_ == kMostTableCurves)
            throw Error(
                Fault::usage, spelled("group"),
                phrase("{0} has more than {1} groups; name a column with few", head_.name, std::to_string(kMostTableCurves)));
        groups_.emplace_back();
        groups_.back().curve.name = name;
        groups_.back().curve.joined = wish_.steps ? Joining::steps : Joining::straight;
        // The first may be all there are. What is never written to costs no memory.
        if (!columns_.group && ups_.size() == 1 && !wish_.points)
            groups_.back().curve.points.reserve(std::min(head_.rows_expected, kMostTableRows));
        return groups_.back();
    }

    void add_mark(PlotMark mark) {
        if (plot_.marks.size() == kMostTableMarks)
            throw Error(Fault::failed, head_.name,
                        phrase("there are more than {0} points to be marked; keep every tenth or hundredth row, for example: awk "
                               "'NR % 100 == 1' FILE",
                               std::to_string(kMostTableMarks)));
        plot_.marks.push_back(std::move(mark));
    }

    void add_point(Group& group, PlotPoint point) {
        std::vector<PlotPoint>& points = group.curve.points;
        if (!points.empty()) {
            const PlotPoint before = points.back();
            group.still = group.still && before.x == point.x && before.y == point.y;
            if (group.apart) group.curve.gaps.push_back(points.size());
            const double way = point.x - before.x;
            if (way * group.way < 0 && ++group.turns > kMostTableTurns)
                throw Error(Fault::failed, head_.name,
                            phrase("rows are joined in their order, and {0} changes direction more than {1} times; sort the rows "
                                   "by it, or keep fewer",
                                   beginning_of(plot_.x.name), std::to_string(kMostTableTurns)));
            if (way != 0) group.way = way;
        }
        group.apart = false;
        points.push_back(point);
        ++group.points;
    }

    // A point without a line on either side is a ring; a curve of one point has its name there, unless it has a label.
    void mark_lone_points(const Group& group) {
        const PlotCurve& curve = group.curve;
        const auto labelled = [&](const PlotPoint& point) {
            return std::any_of(plot_.marks.begin(), plot_.marks.end(),
                               [&](const PlotMark& mark) { return mark.x == point.x && mark.y == point.y; });
        };
        if (group.still) {
            if (!labelled(curve.points[0])) add_mark({curve.name, curve.points[0].x, curve.points[0].y, PlotSymbol::ring});
            return;
        }
        if (curve.gaps.empty()) return;
        for (std::size_t i = 0, gap = 0; i <= curve.gaps.size(); ++i) {
            const std::size_t end = i < curve.gaps.size() ? curve.gaps[i] : curve.points.size();
            if (end - gap == 1 && !labelled(curve.points[gap]))
                add_mark({"", curve.points[gap].x, curve.points[gap].y, PlotSymbol::ring});
            gap = end;
        }
    }

    const TableHead& head_;
    const TableColumns& columns_;
    const TableWish& wish_;
    Plot plot_;
    std::vector<std::size_t> wanted_;
    std::vector<ValueColumn> ups_;
    std::vector<Group> groups_;
    std::unordered_map<std::string, std::size_t> indices_;
    std::size_t last_ = 0, rows_ = 0, left_out_ = 0, gaps_ = 0, turns_ = 0;
    Range across_, up_;
};

}  // namespace

Plot curves_plot(Source& source, const TableHead& head, const TableColumns& columns, const TableWish& wish,
                 std::vector<Phrase>& notes) {
    CurveTable table(head, columns, wish);
    read_rows(source, head, table.wanted(),
              [&](std::size_t line, std::span<const std::string_view> cells, bool apart) { table.take(line, cells, apart); });
    return table.plot(notes);
}

Plot histogram_plot(Source& source, const TableHead& head, const TableColumns& columns, const TableWish& wish,
                    std::vector<Phrase>& notes) {
    const ValueColumn& column = columns.y;
    const Decimal decimal = wish.written.value_or(column.decimal);
    int bins = *wish.histogram;
    std::vector<double> values;
    values.reserve(std::min(head.rows_expected, kMostTableRows));
    Range range;
    std::size_t left_out = 0;
    const std::size_t wanted[] = {column.at};
    read_rows(source, head, wanted, [&](std::size_t line, std::span<const std::string_view> cells, bool) {
        const auto value = value_in(head, column, line, cells[0]);
        if (!value) {
            ++left_out;
            return;
        }
        values.push_back(*value);
        range.take(*value);
    });
    if (values.empty())
        throw Error(
            Fault::failed, head.name,
            phrase("there is no row with a number in {0}; name another column by {1}", beginning_of(column.name), spelled("x")));
    check_range(head, column, range);
    tell_left_out(left_out, notes);
    if (bins == 0) bins = bins_for(values);
    Plot plot;
    plot.title = phrase("How often {0} is where", bare_name(column.name)).in(wish.language);
    plot.x = {column.name, false, column.dates.has_value()};
    plot.x.comma = decimal == Decimal::comma;
    plot.y = {phrase("count").in(wish.language)};
    plot.curves.push_back(histogram_of(values, bins));
    notes.push_back(
        phrase("{0} values in {1} bars", std::to_string(values.size()), std::to_string(plot.curves[0].points.size() - 1)));
    return plot;
}

}  // namespace tactics
