// SPDX-License-Identifier: Apache-2.0
#include "filters/chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "filters/chart_letters.h"
#include "filters/curves_apart.h"
#include "filters/thinned_curve.h"
#include "filters/ticks.h"
#include "tactics/error.h"
#include "tactics/geometry/shape.h"
#include "tactics/geometry/walk.h"
#include "tactics/layout/label.h"
#include "tactics/layout/place.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr int kFewestTicks = 3, kMostTicks = 6;  // an axis
constexpr double kLeastPiece = 6.5;              // mm of a curve; less is felt as a mark (rules/dashes.cpp)
constexpr double kLeastSide = 50;                // mm; a smaller field of data cannot be read by touch

// From values to millimetres along one axis.
class Scale {
public:
    Scale(const Axis& axis, double low, double high, int most_ticks, double from, double to)
        : logarithmic_(axis.logarithmic), ticks_(ticks_for(low, high, axis.logarithmic, most_ticks)), from_(from), to_(to) {}

    double at(double value) const {
        const double first = bent(ticks_.low), last = bent(ticks_.high);
        return from_ + (bent(value) - first) / (last - first) * (to_ - from_);
    }
    const std::vector<double>& ticks() const { return ticks_.at; }

private:
    double bent(double value) const { return logarithmic_ ? std::log10(value) : value; }
    bool logarithmic_;
    Ticks ticks_;
    double from_, to_;
};

struct Range {
    double low = INFINITY, high = -INFINITY;
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

// a, b, ... z, aa, ab ...: what stands beside a mark and begins its line in the key.
std::string letter_of(std::size_t index) {
    const std::string last(1, static_cast<char>('a' + index % 26));
    return index < 26 ? last : letter_of(index / 26 - 1) + last;
}

std::vector<Point> circle(Point centre, double radius) {
    constexpr int kCorners = 32;
    std::vector<Point> points;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return points;
}

// Where a letter may stand: at the end of a curve, or, the later the better, every 12 mm before it.
std::vector<Point> places_on(const std::vector<std::vector<Point>>& pieces) {
    constexpr double kApart = 12;  // mm
    constexpr std::size_t kMost = 16;
    std::vector<Point> places;
    for (auto piece = pieces.rbegin(); piece != pieces.rend() && places.size() < kMost; ++piece) {
        const std::vector<Point> back(piece->rbegin(), piece->rend());
        const double length = length_of(back, false);
        Walk walk(back, false);
        for (double along = 0; (along == 0 || along < length) && places.size() < kMost; along += kApart)
            places.push_back(walk.to(along));
    }
    return places;
}

class Chart {
public:
    Chart(const Plot& plot, const Sheet& sheet, double width, double height)
        : plot_(plot), sheet_(sheet), clear_(clearance_on(*sheet.medium)) {
        drawing_.width = width;
        drawing_.height = height;
    }

    Drawing draw() {
        const Range x = range_of(&PlotMark::x, &PlotPoint::x), y = range_of(&PlotMark::y, &PlotPoint::y);
        const double bottom = draw_key();
        // The ticks' words decide how much room is left; an upright block of words is about as high as 12 mm.
        const LabelBlock name_y = set_label(plot_.y.name, sheet_), name_x = set_label(plot_.x.name, sheet_);
        double words_y = 0, words_x = 0, height_x = 0, height_y = 0;
        for (int most = kFewestTicks; most <= kMostTicks; ++most) {
            for (const double tick : ticks_for(y.low, y.high, plot_.y.logarithmic, most).at) {
                const LabelBlock words = set_label(to_text(tick), sheet_);
                words_y = std::max(words_y, words.width);
                height_y = std::max(height_y, words.height);
            }
            for (const double tick : ticks_for(x.low, x.high, plot_.x.logarithmic, most).at) {
                const LabelBlock words = set_label(to_text(tick), sheet_);
                words_x = std::max(words_x, words.width);
                height_x = std::max(height_x, words.height);
            }
        }
        // Half of the lowest tick's words hang below the axis.
        below_axis_ = std::max(kChartTick + clear_.down, height_y / 2 + kChartLines);
        top_ = name_y.height;
        field_.left = words_y + clear_.across + kChartTick;
        field_.top = top_ + height_y / 2 + kChartLines;
        field_.width = drawing_.width - words_x / 2 - field_.left;
        field_.height = bottom - name_x.height - height_x - 2 * kChartLines - below_axis_ - field_.top;
        // A letter has room over the highest mark.
        const double over = set_label("m", sheet_).height + clear_.mark + clear_.down + kChartLines - (field_.top - top_);
        if (field_.width < kLeastSide || field_.height < kLeastSide + over)
            throw Error(Fault::usage, "", "the chart does not fit on this paper; take larger paper, or fewer things to compare");
        // No mark touches an axis or its ticks, or leaves the drawing.
        const double inset = kChartTick + clear_.mark + kChartClear, edge = clear_.mark + sheet_.medium->thin_line;
        const Scale across = scale(plot_.x, x, field_.left + inset, field_.left + field_.width - edge, false);
        const Scale up = scale(plot_.y, y, field_.top + field_.height - inset, field_.top + std::max(edge, over), true);
        draw_axes(across, up);
        draw_data(across, up);
        label({0, 0}, 0, 0, plot_.y.name);
        label({field_.left + field_.width, field_.top + field_.height + below_axis_ + height_x + kChartLines}, 1, 0,
              plot_.x.name);
        return std::move(drawing_);
    }

private:
    template <class OfMark, class OfPoint>
    Range range_of(OfMark of_mark, OfPoint of_point) const {
        Range range;
        for (const PlotMark& mark : plot_.marks) range.take(mark.*of_mark);
        for (const PlotCurve& curve : plot_.curves)
            for (const PlotPoint& point : curve.points) range.take(point.*of_point);
        if (!(range.low <= range.high)) throw Error(Fault::usage, "", "there is nothing to plot");
        return range;
    }

    // With as many ticks as their words have room for.
    Scale scale(const Axis& axis, const Range& range, double from, double to, bool upright) const {
        const auto room = [&](double tick) {
            const LabelBlock words = set_label(to_text(tick), sheet_);
            return upright ? words.height + kChartLines : words.width + clear_.words;
        };
        for (int most = kMostTicks;; --most) {
            Scale scale(axis, range.low, range.high, most, from, to);
            const std::vector<double>& ticks = scale.ticks();
            bool fits = true;
            for (std::size_t i = 1; i < ticks.size(); ++i)
                fits = fits && 2 * std::abs(scale.at(ticks[i]) - scale.at(ticks[i - 1])) >= room(ticks[i]) + room(ticks[i - 1]);
            if (fits || most == kFewestTicks) return scale;
        }
    }

    void label(Point at, double across, double down, const std::string& text) {
        if (!text.empty()) drawing_.labels.push_back({at, across, down, text});
    }

    // The key stands at the bottom, in as many columns as it has room for. Gives where it begins.
    double draw_key() {
        std::vector<std::string> lines;
        for (const PlotCurve& curve : plot_.curves)
            if (!curve.name.empty()) lines.push_back(letter_of(lines.size()) + " " + curve.name);
        for (const PlotMark& mark : plot_.marks)
            if (!mark.name.empty()) lines.push_back(letter_of(lines.size()) + " " + mark.name);
        double width = 0, height = 0;
        for (const std::string& line : lines) {
            const LabelBlock block = set_label(line, sheet_);
            width = std::max(width, block.width);
            height = std::max(height, block.height);
        }
        const double between = clear_.words + 4;  // a blank that no line of words has
        const double columns = std::max(1.0, std::floor((drawing_.width + between) / (width + between)));
        const double rows = std::ceil(static_cast<double>(lines.size()) / columns);
        const double pitch = height + kChartLines, top = drawing_.height - rows * pitch;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double column = std::floor(static_cast<double>(i) / rows), row = static_cast<double>(i) - column * rows;
            label({column * (width + between), top + row * pitch + kChartLines}, 0, 0, lines[i]);
        }
        return top;
    }

    void line(std::vector<Point> points, LineClass width, Role role = Role::line) {
        drawing_.strokes.push_back({std::move(points), false, width, 0, role});
    }

    void draw_axes(const Scale& across, const Scale& up) {
        const double bottom = field_.top + field_.height;
        line({{field_.left, field_.top}, {field_.left, bottom}, {field_.left + field_.width, bottom}}, LineClass::thin,
             Role::axis);
        for (const double tick : across.ticks()) {
            line({{across.at(tick), bottom - kChartTick}, {across.at(tick), bottom + kChartTick}}, LineClass::thin, Role::tick);
            label({across.at(tick), bottom + below_axis_}, 0.5, 0, to_text(tick));
        }
        for (const double tick : up.ticks()) {
            line({{field_.left - kChartTick, up.at(tick)}, {field_.left + kChartTick, up.at(tick)}}, LineClass::thin, Role::tick);
            label({field_.left - kChartTick - clear_.across, up.at(tick)}, 1, 0.5, to_text(tick));
        }
    }

    void draw_data(const Scale& across, const Scale& up) {
        std::vector<ChartTag> tags;
        draw_curves(across, up, tags);
        for (const PlotMark& mark : plot_.marks) {
            const Point at{across.at(mark.x), up.at(mark.y)};
            if (!mark.name.empty()) tags.push_back(tag({at}, tags.size()));
            marks_.push_back(at);
            if (mark.symbol == PlotSymbol::disc)
                drawing_.areas.push_back({{circle(at, clear_.mark)}, Role::symbol});
            else
                drawing_.strokes.push_back({circle(at, clear_.mark), true, LineClass::thin, 0, Role::symbol});
        }
        place_letters(tags, {drawing_, *sheet_.medium, clear_, field_, top_, marks_});
        for (const ChartTag& one : tags) {
            if (const auto lead = lead_of(one, clear_); !lead.empty()) line(lead, LineClass::thin, Role::lead);
            label({one.place.left, one.place.top}, 0, 0, one.letter);
        }
    }

    void draw_curves(const Scale& across, const Scale& up, std::vector<ChartTag>& tags) {
        std::vector<std::vector<Point>> curves;
        for (const PlotCurve& curve : plot_.curves) {
            curves.emplace_back();
            for (const PlotPoint& point : curve.points) curves.back().push_back({across.at(point.x), up.at(point.y)});
            curves.back() = thinned_curve(std::move(curves.back()), kCurveColumn);
        }
        const auto pieces = curves_apart(curves, sheet_.medium->line + kChartClear, kLeastPiece);
        for (std::size_t i = 0; i < curves.size(); ++i) {
            // A curve that runs along another from end to end has its letter beside that one.
            const auto named = pieces[i].empty() ? std::vector<std::vector<Point>>{curves[i]} : pieces[i];
            if (!plot_.curves[i].name.empty() && !curves[i].empty()) {
                tags.push_back(tag(places_on(named), tags.size()));
                for (std::size_t k = 0; k < pieces[i].size(); ++k) tags.back().curve.push_back(drawing_.strokes.size() + k);
            }
            for (const auto& piece : pieces[i]) line(piece, LineClass::normal);
        }
    }

    ChartTag tag(std::vector<Point> places, std::size_t index) const {
        const std::string letter = letter_of(index);
        return {std::move(places), letter, set_label(letter, sheet_), {}};
    }

    const Plot& plot_;
    const Sheet& sheet_;
    const Clearance clear_;
    Drawing drawing_;
    std::vector<Point> marks_;
    double top_ = 0;  // where the words above the field end
    Rect field_;
    double below_axis_ = 0;  // to where its ticks' words begin
};

}  // namespace

Drawing draw_chart(const Plot& plot, const Sheet& sheet) {
    const Place place = place_on(sheet, 1);
    const Rect& live = place.live;
    return Chart(plot, sheet, live.width, live.top + live.height - place.drawing.top).draw();
}

}  // namespace tactics
