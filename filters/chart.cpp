// SPDX-License-Identifier: Apache-2.0
#include "filters/chart.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "filters/bar_chart.h"
#include "filters/chart_axis.h"
#include "filters/chart_contours.h"
#include "filters/chart_curves.h"
#include "filters/chart_frame.h"
#include "filters/chart_grid.h"
#include "filters/chart_key.h"
#include "filters/chart_letters.h"
#include "filters/chart_marks.h"
#include "filters/curves_apart.h"
#include "filters/plot_symbols.h"
#include "tactics/error.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/line_styles.h"
#include "tactics/geometry/shape.h"
#include "tactics/geometry/walk.h"
#include "tactics/layout/label.h"
#include "tactics/layout/place.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kSlack = 0.1;  // mm: lines are simplified
constexpr int kChartRounds = 3;
constexpr double kLeastPiece = 6.5;  // mm of a curve; less is felt as a mark (rules/dashes.cpp)

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

double distance_to(const std::vector<std::vector<Point>>& lines, Point at) {
    double least = INFINITY;
    for (const auto& line : lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) least = std::min(least, distance_to_segment(at, line[i], line[i + 1]));
    return least;
}

struct SymbolPlace {
    Point at;
    double reach = 0;  // mm
};

using Pieces = std::vector<std::vector<Point>>;

class Chart {
public:
    Chart(const Plot& plot, const Sheet& sheet, const ChartWish& wish, const Place& place, Notes& notes)
        : plot_(plot),
          sheet_(sheet),
          medium_(*sheet.medium),
          wish_(wish),
          notes_(notes),
          clear_(clearance_on(*sheet.medium)),
          cells_(sheet, place, {place.live.left, place.drawing.top}),
          groups_(groups_of(plot.marks)) {
        drawing_.width = place.live.width;
        drawing_.height = place.live.top + place.live.height - place.drawing.top;
        const auto named = [](const PlotCurve& curve) { return !curve.name.empty(); };
        lettered_ = static_cast<std::size_t>(std::count_if(plot.curves.begin(), plot.curves.end(), named)) > kLineStyles;
        if (lettered_)
            notes_.push_back(
                to_act_on(phrase("a finger tells {0} kinds of lines, and there are more curves, so all are whole lines with a "
                                 "letter each, which is hard to follow where they cross; make a chart for every {1} of them, "
                                 "each of a table with the rows of those only",
                                 std::to_string(kLineStyles), std::to_string(kLineStyles))));
    }

    ChartFrame frame_over(const ChartKey& key) const {
        return frame_for(plot_, sheet_, clear_, drawing_.width, drawing_.height - key.height());
    }
    ChartKey key_below() const { return {key_entries(), sheet_, cells_, clear_, drawing_.width}; }

    Drawing draw(ChartTold& told) {
        const ChartKey key = key_below();
        const ChartFrame frame = frame_over(key);
        told.x = frame.across.place();
        told.y = frame.up.place();
        field_ = frame.field;
        top_ = frame.top;
        draw_axes(frame, clear_, drawing_);
        draw_data(frame.across, frame.up);
        draw_names(frame, sheet_, drawing_);
        if (wish_.grid) draw_grid(drawing_, grid_lines(frame), words_in_field(), medium_);
        key.draw(drawing_);
        return std::move(drawing_);
    }

private:
    // Letters are given in this order: to curves, if they have any, then to marks.
    std::vector<ChartKeyEntry> key_entries() const {
        std::vector<ChartKeyEntry> entries;
        std::size_t letter = 0, style = 0;
        for (const PlotCurve& curve : plot_.curves) {
            if (curve.name.empty()) continue;
            if (lettered_)
                entries.push_back({letter_of(letter++) + " " + curve.name});
            else
                entries.push_back({curve.name, style++});
        }
        for (const PlotMark& mark : plot_.marks) {
            if (mark.name.empty()) continue;
            if (groups_.has(mark.symbol))
                entries.push_back({mark.name, {}, mark.symbol});
            else
                entries.push_back({letter_of(letter++) + " " + mark.name});
        }
        return entries;
    }

    void line(std::vector<Point> points, LineClass width, Role role = Role::line) {
        drawing_.strokes.push_back({std::move(points), false, width, 0, role});
    }

    void draw_data(const AxisScale& across, const AxisScale& up) {
        std::vector<ChartCurve> curves;
        for (const PlotCurve& curve : plot_.curves) {
            curves.push_back(curve_on(curve, across, up, plot_.y.logarithmic, medium_));
            tell_thinned(curve, curves.back());
        }
        std::vector<ChartLevel> levels;
        if (!plot_.surfaces.empty())
            levels = levels_on(plot_.surfaces[0], across, up, wish_.levels, {field_, sheet_, cells_, clear_, plot_.z});
        std::size_t left_out = 0, repeated = 0;
        const double gap = std::max({medium_.gap + medium_.thin_line, kChartClear + medium_.thin_line, rows_}) + kSlack;
        const std::vector<ChartMark> marks = marks_apart(plot_.marks, groups_, across, up, clear_.mark, gap, left_out, repeated);
        tell_left_out(left_out, repeated);

        for (const ChartMark& one : marks) symbols_.push_back({one.at, reach_of(one.mark->symbol, clear_.mark)});
        for (const ChartCurve& curve : curves)
            for (const Point& alone : curve.alone) symbols_.push_back({alone, clear_.mark});

        std::vector<ChartTag> tags;
        draw_lines(curves, levels, tags);
        for (const ChartMark& one : marks) {
            if (!one.mark->name.empty() && !groups_.has(one.mark->symbol)) tags.push_back(tag({one.at}, letter_of(letters_++)));
            draw_symbol(one.mark->symbol, one.at, clear_.mark, drawing_);
        }
        for (std::size_t i = marks.size(); i < symbols_.size(); ++i)
            draw_symbol(PlotSymbol::disc, symbols_[i].at, clear_.mark, drawing_);
        std::vector<Point> places;
        for (const SymbolPlace& symbol : symbols_) places.push_back(symbol.at);
        place_letters(tags, {drawing_, medium_, clear_, field_, top_, places, cells_, words_in_field()});
        for (const ChartTag& one : tags) {
            if (const auto lead = lead_of(one, clear_); !lead.empty()) line(lead, LineClass::thin, Role::lead);
            drawing_.labels.push_back({{one.place.left, one.place.top}, 0, 0, one.letter});
        }
    }

    // Of curves and contours, what keeps apart from all others, from symbols and from words.
    void draw_lines(const std::vector<ChartCurve>& curves, const std::vector<ChartLevel>& levels, std::vector<ChartTag>& tags) {
        std::vector<LineStyle> styles;
        std::size_t named = 0;
        for (const PlotCurve& curve : plot_.curves)
            styles.push_back(curve.name.empty() || lettered_ ? LineStyle{} : line_style(named++, medium_));
        for (const ChartLevel& level : levels) styles.push_back({level.index ? LineClass::thick : LineClass::normal});
        // Whole lines are the last to be broken: gaps of others are felt as a part of their style.
        std::vector<std::size_t> order;
        for (const bool whole : {true, false})
            for (std::size_t i = 0; i < styles.size(); ++i)
                if (styles[i].is_whole() == whole) order.push_back(i);
        std::vector<ApartCurve> all;
        std::vector<std::vector<SymbolPlace>> symbols;  // of each, those that it may not come near
        std::vector<double> widths;
        for (const std::size_t i : order) {
            const Pieces& lines = i < curves.size() ? curves[i].lines : levels[i - curves.size()].lines;
            const bool bars = i < curves.size() && plot_.curves[i].joined == Joining::bars;
            widths.push_back(width_of(styles[i].line, medium_));
            all.push_back({lines, widths.back(), !bars});
            symbols.push_back(symbols_beside(lines, styles[i], widths.back()));
        }
        ApartWish wish{std::max(medium_.gap, kChartClear), kLeastPiece, rows_, {}};
        wish.blocked = [&](std::size_t curve, Point at) {
            const double least = std::max(wish.gap + (widths[curve] + medium_.thin_line) / 2, wish.rows) + kSlack;
            return std::any_of(symbols[curve].begin(), symbols[curve].end(),
                               [&](const SymbolPlace& symbol) { return distance(symbol.at, at) < symbol.reach + least; }) ||
                   std::any_of(levels.begin(), levels.end(),
                               [&](const ChartLevel& level) { return level.label && kept_by(*level.label, clear_).holds(at); });
        };
        auto apart = curves_apart(all, wish);
        // Where a line that ran into a symbol is broken near it, it ends before the symbol, as others do.
        for (int round = 0; round < kChartRounds && end_before_symbols(all, apart, symbols); ++round)
            apart = curves_apart(all, wish);
        std::vector<Pieces> pieces(order.size());
        for (std::size_t k = 0; k < order.size(); ++k) pieces[order[k]] = apart[k];
        for (std::size_t i = 0; i < curves.size(); ++i) draw_curve(i, curves[i], styles[i], pieces[i], tags);
        for (std::size_t i = 0; i < levels.size(); ++i)
            draw_level(levels[i], styles[curves.size() + i], pieces[curves.size() + i]);
    }

    // A symbol may stand on a whole line; others end before it, as a gap beside it would be felt as a gap of theirs.
    std::vector<SymbolPlace> symbols_beside(const Pieces& lines, const LineStyle& style, double width) const {
        constexpr double kOn = 0.7;  // of its reach: nearer to its middle the line runs into it
        std::vector<SymbolPlace> beside;
        for (const SymbolPlace& symbol : symbols_)
            if (!style.is_whole() || distance_to(lines, symbol.at) > kOn * symbol.reach + width / 2) beside.push_back(symbol);
        return beside;
    }

    // True: some have more symbols now that they may not come near.
    bool end_before_symbols(const std::vector<ApartCurve>& all, const std::vector<Pieces>& apart,
                            std::vector<std::vector<SymbolPlace>>& symbols) const {
        bool any = false;
        for (std::size_t i = 0; i < all.size(); ++i)
            for (const SymbolPlace& symbol : symbols_) {
                const double away = distance_to(apart[i], symbol.at),
                             least = std::max(medium_.gap + all[i].width, rows_) + kSlack + symbol.reach;
                if (away <= symbol.reach || away >= least - kSlack) continue;
                if (distance_to(all[i].lines, symbol.at) > symbol.reach) continue;
                symbols[i].push_back(symbol);
                any = true;
            }
        return any;
    }

    void draw_curve(std::size_t number, const ChartCurve& curve, const LineStyle& style, const Pieces& pieces,
                    std::vector<ChartTag>& tags) {
        const std::string& name = plot_.curves[number].name;
        const std::size_t first = drawing_.strokes.size();
        for (const auto& piece : pieces) draw_piece(piece, style);
        for (const auto& ring : curve.filled) drawing_.areas.push_back({{ring}});
        if (pieces.empty() && !curve.lines.empty() && !name.empty())
            notes_.push_back(phrase("\"{0}\" runs along other curves from end to end and is not drawn by itself", name));
        if (!lettered_ || name.empty()) return;
        const std::string letter = letter_of(letters_++);
        // A curve that runs along another from end to end has its letter beside that one.
        const Pieces& named = pieces.empty() ? curve.lines : pieces;
        if (named.empty()) return;
        tags.push_back(tag(places_on(named), letter));
        for (std::size_t k = first; k < drawing_.strokes.size(); ++k) tags.back().curve.push_back(k);
    }

    void draw_level(const ChartLevel& level, const LineStyle& style, const Pieces& pieces) {
        for (const auto& piece : pieces) draw_piece(piece, style);
        if (level.label) {
            drawing_.labels.push_back({{level.label->left, level.label->top}, 0, 0, level.words});
            words_.push_back(*level.label);
        } else if (!pieces.empty()) {
            notes_.push_back(to_act_on(phrase("the contour of {0} has no room for its height, which is left out", level.words)));
        }
        if (pieces.empty() && !level.lines.empty())
            notes_.push_back(to_act_on(phrase("the contour of {0} has no room between others and is left out", level.words)));
    }

    void draw_piece(std::vector<Point> piece, const LineStyle& style) {
        const bool closed = piece.size() > 3 && distance(piece.front(), piece.back()) == 0;
        if (closed) piece.pop_back();
        auto strokes = in_style(piece, closed, style, medium_);
        std::move(strokes.begin(), strokes.end(), std::back_inserter(drawing_.strokes));
    }

    std::vector<Rect> words_in_field() const {
        std::vector<Rect> all;
        for (const Rect& words : words_) all.push_back(kept_by(words, clear_));
        return all;
    }

    void tell_thinned(const PlotCurve& curve, const ChartCurve& drawn) {
        if (drawn.every < 1) return;
        notes_.push_back(
            phrase("{0} goes up and down faster than a finger can follow, and is drawn through one of its points every {1} mm, "
                   "that with the middle value; larger paper or fewer points show more",
                   curve.name.empty() ? phrase("the curve") : phrase("\"{0}\"", curve.name), numeral(drawn.every)));
    }

    void tell_left_out(std::size_t left_out, std::size_t repeated) {
        if (left_out == 0) return;
        const std::string count = std::to_string(left_out), all = std::to_string(plot_.marks.size());
        notes_.push_back(repeated > 0 ? phrase("{0} of {1} points have no symbol of their own, as they are too near to one that "
                                               "has ({2} at its very place); larger paper shows more",
                                               count, all, std::to_string(repeated))
                                      : phrase("{0} of {1} points have no symbol of their own, as they are too near to one that "
                                               "has; larger paper shows more",
                                               count, all));
    }

    ChartTag tag(std::vector<Point> places, const std::string& letter) const {
        return {std::move(places), letter, set_label(letter, sheet_), {}};
    }

    const Plot& plot_;
    const Sheet& sheet_;
    const Medium& medium_;
    const ChartWish& wish_;
    Notes& notes_;
    const Clearance clear_;
    const double rows_ = has_fixed_dots(medium_) ? kTwoRows : 0;  // mm from the middle of a line to that of another
    const CellPlaces cells_;
    const MarkGroups groups_;
    Drawing drawing_;
    std::vector<SymbolPlace> symbols_;
    std::vector<Rect> words_;  // in the field
    bool lettered_ = false;    // curves have letters and not styles
    std::size_t letters_ = 0;  // that are given
    double top_ = 0;           // where the words above the field end
    Rect field_;
};

Plot flat_plot(const Plot& plot, const Sheet& sheet, const ChartWish& wish, Notes& told) {
    Plot flat = plot;
    if (!plot.surfaces.empty() && wish.view == SurfaceView::sections)
        flat = sections_of(plot, plot.surfaces.front(), wish.sections);
    if (plot.surfaces.size() > 1)
        told.push_back(phrase("there are {0} surfaces, of which the first is drawn", std::to_string(plot.surfaces.size())));
    if (flatten_marks(flat, sheet.language))
        told.push_back(phrase("points of several kinds are seen from above, and how high they are is not shown"));
    return flat;
}

enum class AxisFit { none, ends, ticks };

// Whether the words at round values have room, or only those of the ends, or not even these.
AxisFit fit_on(const Plot& flat, const Sheet& sheet, const ChartWish& wish) {
    Notes unheard;
    try {
        const Chart chart(flat, sheet, wish, place_on(sheet, 1), unheard);
        return chart.frame_over(chart.key_below()).across.moved() ? AxisFit::ends : AxisFit::ticks;
    } catch (const Error&) {
        return AxisFit::none;
    }
}

}  // namespace

Sheet sheet_of_chart(const Plot& plot, const Sheet& sheet, const ChartWish& wish) {
    if (plot.bars || sheet.orientation != Orientation::automatic) return sheet;
    Notes unheard;
    const Plot flat = flat_plot(plot, sheet, wish, unheard);
    const AxisFit fit = fit_on(flat, sheet, wish);
    if (fit == AxisFit::ticks) return sheet;
    Sheet turned = sheet;
    turned.orientation = Orientation::landscape;
    return fit_on(flat, turned, wish) > fit ? turned : sheet;
}

Drawing draw_chart(const Plot& plot, const Sheet& sheet, const ChartWish& wish, Notes* notes, ChartTold* told_of_it) {
    Notes unheard;
    Notes& told = notes != nullptr ? *notes : unheard;
    ChartTold unasked;
    ChartTold& places = told_of_it != nullptr ? *told_of_it : unasked;
    if (plot.bars) return draw_bars(plot, sheet, wish, told, places);
    const Plot flat = flat_plot(plot, sheet, wish, told);
    return Chart(flat, sheet, wish, place_on(sheet, 1), told).draw(places);
}

double chart_aspect(const Sheet& sheet) {
    const Place place = place_on(sheet, 1);
    return place.live.width / (place.live.top + place.live.height - place.drawing.top);
}

}  // namespace tactics
