// SPDX-License-Identifier: Apache-2.0
#include "filters/bar_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "filters/bar_frame.h"
#include "filters/chart_grid.h"
#include "filters/chart_key.h"
#include "tactics/error.h"
#include "tactics/layout/place.h"
#include "tactics/layout/texture.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

// Numbers of textures.inc, those first that differ most and fill a narrow bar best.
constexpr int kTextures[kMostSeries] = {5, 2, 1, 4, 3};
constexpr double kInnerBorder = 0.5;  // mm from the outer dots of a solid bar to its border
constexpr double kCap = 3.2;          // mm on either side of an error bar: as long as a textured part is wide, 6.4 mm

// From one end of a part of a bar to the other, along the axis of values, mm.
struct BarPart {
    double from = 0, to = 0;
    int texture = 0;
};

class BarChart {
public:
    BarChart(const Plot& plot, const Sheet& sheet, const ChartWish& wish, Notes& notes, ChartTold& told)
        : plot_(plot),
          bars_(*plot.bars),
          sheet_(sheet),
          medium_(*sheet.medium),
          wish_(wish),
          notes_(notes),
          told_(told),
          clear_(clearance_on(medium_)),
          place_(place_on(sheet, 1)),
          cells_(sheet, place_, {place_.live.left, place_.drawing.top}),
          least_(std::max(medium_.gap + medium_.line, has_fixed_dots(medium_) ? kTwoRows : 0)) {
        drawing_.width = place_.live.width;
        drawing_.height = place_.live.top + place_.live.height - place_.drawing.top;
        for (const PlotSeries& series : bars_.series) has_errors_ = has_errors_ || !series.errors.empty();
    }

    Drawing draw() {
        for (const bool keyed : kNamings) {
            const ChartKey key(key_entries(keyed), sheet_, cells_, clear_, drawing_.width);
            const BarRoom room = room_over(key);
            const auto frame = frame_in(room, keyed ? letters() : bars_.categories);
            if (!frame) continue;
            if (keyed) told_.letters = letters();
            draw_bar_frame(*frame, room, drawing_);
            draw_all(*frame);
            if (wish_.grid) draw_grid_of(*frame);
            key.draw(drawing_);
            tell(*frame);
            return std::move(drawing_);
        }
        refuse();
    }

private:
    static constexpr std::array kNamings{false, true};  // by their names, else by letters that the key explains

    BarRoom room_over(const ChartKey& key) const {
        return {sheet_, clear_, cells_, drawing_.width, drawing_.height - key.height()};
    }

    std::vector<std::string> letters() const {
        std::vector<std::string> all;
        for (std::size_t i = 0; i < bars_.categories.size(); ++i) all.push_back(letter_of(i));
        return all;
    }

    std::vector<ChartKeyEntry> key_entries(bool keyed) const {
        std::vector<ChartKeyEntry> entries;
        if (bars_.series.size() > 1)
            for (std::size_t i = 0; i < bars_.series.size(); ++i) entries.push_back({bars_.series[i].name, {}, {}, kTextures[i]});
        if (keyed)
            for (std::size_t i = 0; i < bars_.categories.size(); ++i)
                entries.push_back({letter_of(i) + " " + bars_.categories[i]});
        return entries;
    }

    std::vector<BarLook> looks() const {
        if (bars_.series.size() == 1 && !has_errors_)
            return {BarLook::outlined, has_fixed_dots(medium_) ? BarLook::solid : BarLook::hollow};
        return {BarLook::outlined, BarLook::bare};
    }

    std::vector<bool> ways() const {
        if (bars_.way == BarWay::automatic) return {false, true};
        return {bars_.way == BarWay::level};
    }

    std::optional<BarFrame> frame_in(const BarRoom& room, const std::vector<std::string>& names) const {
        for (const bool level : ways())
            for (const BarLook look : looks())
                if (auto frame = bar_frame(plot_, names, level, look, room)) return frame;
        return std::nullopt;
    }

    bool has_room() const {
        return std::any_of(kNamings.begin(), kNamings.end(), [&](bool keyed) {
            const ChartKey key(key_entries(keyed), sheet_, cells_, clear_, drawing_.width);
            return frame_in(room_over(key), keyed ? letters() : bars_.categories).has_value();
        });
    }

    // How many of the first categories would have room.
    std::size_t most_with_room() const {
        std::size_t fits = 0, fails = bars_.categories.size();
        while (fails - fits > 1) {
            const std::size_t count = fits + (fails - fits) / 2;
            Plot fewer = plot_;
            fewer.bars->categories.resize(count);
            for (PlotSeries& series : fewer.bars->series) series.values.resize(count);
            Notes unheard;
            ChartTold untold;
            (BarChart(fewer, sheet_, wish_, unheard, untold).has_room() ? fits : fails) = count;
        }
        return fits;
    }

    [[noreturn]] void refuse() const {
        const std::size_t fits = most_with_room(), series = bars_.stacked ? 1 : bars_.series.size();
        throw Error(
            Fault::usage, "",
            phrase("{0} would be too close for a finger on this paper, {1}; take larger paper, {2} landscape or {3}, or a table "
                   "with fewer rows",
                   series > 1 ? phrases(bars_.categories.size(), "{0} group of {1} bars with its name",
                                        "{0} groups of {1} bars with their names", std::to_string(series))
                              : phrases(bars_.categories.size(), "{0} bar with its name", "{0} bars with their names"),
                   fits > 0 ? phrase("which has room for {0}", std::to_string(fits)) : phrase("which has no room for one"),
                   spelled("orientation"), spelled("no-print-title")));
    }

    Point at(const BarFrame& frame, double along, double value) const {
        return frame.level ? Point{value, frame.first + along} : Point{frame.first + along, value};
    }

    void draw_all(const BarFrame& frame) {
        const double zero = frame.values.at(0);
        for (std::size_t i = 0; i < bars_.categories.size(); ++i) {
            std::vector<BarPart> up, down;  // of a stack
            double above = 0, below = 0;
            for (std::size_t k = 0; k < bars_.series.size(); ++k) {
                const double value = bars_.series[k].values[i];
                if (std::isnan(value)) {
                    ++unknown_;
                    continue;
                }
                const double begin = frame.places.begin_of(i, bars_.stacked ? 0 : k), end = begin + frame.places.thickness;
                double& sum = value < 0 ? below : above;
                if (!bars_.stacked) sum = 0;
                const double from = frame.values.at(sum), to = frame.values.at(sum + value);
                sum += value;
                std::vector<BarPart>& stack = value < 0 ? down : up;
                if (value != 0) stack.push_back({from, to, kTextures[k]});
                if (bars_.stacked) continue;
                draw_bar(frame, begin, end, zero, stack);
                draw_error(frame, (begin + end) / 2, k, i);
                stack.clear();
            }
            const double begin = frame.places.begin_of(i, 0), end = begin + frame.places.thickness;
            draw_bar(frame, begin, end, zero, up);
            draw_bar(frame, begin, end, zero, down);
        }
    }

    // Of a bar and what keeps clear of it.
    Rect box_of(const BarFrame& frame, double begin, double end, double from, double to) const {
        const Point a = at(frame, begin, std::min(from, to)), b = at(frame, end, std::max(from, to));
        return {a.x - medium_.gap, a.y - medium_.gap, b.x - a.x + 2 * medium_.gap, b.y - a.y + 2 * medium_.gap};
    }

    void area(const BarFrame& frame, double begin, double end, double from, double to, int texture) {
        drawing_.areas.push_back(
            {{{at(frame, begin, from), at(frame, end, from), at(frame, end, to), at(frame, begin, to)}}, Role::line, texture});
    }

    // What is too low to be felt is counted with its larger neighbour, whose texture the two have.
    std::vector<BarPart> felt_parts(std::vector<BarPart> parts, double zero) {
        for (std::size_t i = 0; i < parts.size(); ++i) parts[i].from = i == 0 ? zero : parts[i - 1].to;
        const auto high = [&](std::size_t i) { return i < parts.size() ? std::abs(parts[i].to - parts[i].from) : -1.0; };
        while (parts.size() > 1) {
            std::size_t low = 0;
            for (std::size_t i = 1; i < parts.size(); ++i) low = high(i) < high(low) ? i : low;
            if (high(low) >= least_) break;
            const std::size_t other = low == 0 || high(low + 1) > high(low - 1) ? low + 1 : low - 1;
            const std::size_t first = std::min(low, other);
            parts[first] = {parts[first].from, parts[first + 1].to, parts[other].texture};
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(first) + 1);
            ++left_out_;
        }
        return parts;
    }

    // Its parts go from 0 outwards.
    void draw_bar(const BarFrame& frame, double begin, double end, double zero, const std::vector<BarPart>& parts) {
        if (parts.empty()) return;
        bar_boxes_.push_back(box_of(frame, begin, end, zero, parts.back().to));
        const double tip = parts.back().to, outwards = tip < zero ? -1 : 1;
        if (std::abs(tip - zero) < least_) {
            area(frame, begin, end, zero, zero + outwards * std::max(std::abs(tip - zero), medium_.line), 0);
            ++short_;
            return;
        }
        if (frame.places.look == BarLook::solid) return area(frame, begin - kInnerBorder, end + kInnerBorder, zero, tip, 0);
        const bool bare = frame.places.look == BarLook::bare;
        const double inset = bare ? least_ / 2 : 0;
        const auto line = [&](std::vector<Point> points) {
            drawing_.strokes.push_back({std::move(points), false, LineClass::normal});
        };
        const std::vector<BarPart> felt = felt_parts(parts, zero);
        for (const BarPart& part : felt) {
            if (&part != &felt.back() || bare) line({at(frame, begin + inset, part.to), at(frame, end - inset, part.to)});
            if (frame.places.look == BarLook::hollow) continue;
            area(frame, begin, end, part.from, part.to, part.texture);
            if (std::abs(part.to - part.from) < kLeastTexture + 2 * least_) ++low_;
        }
        if (!bare) line({at(frame, begin, zero), at(frame, begin, tip), at(frame, end, tip), at(frame, end, zero)});
    }

    // A line across the bar's end with a cap at each of its own, or a half of it where the other is not felt.
    void draw_error(const BarFrame& frame, double middle, std::size_t series, std::size_t category) {
        const std::vector<PlotRange>& errors = bars_.series[series].errors;
        if (errors.empty() || std::isnan(errors[category].low)) return;
        const double tip = frame.values.at(bars_.series[series].values[category]), zero = frame.values.at(0);
        // As wide as the end of a bare bar; within an outlined one clear of its sides.
        const double cap = std::min(kCap, (frame.places.thickness - (frame.places.look == BarLook::bare ? 1 : 2) * least_) / 2);
        bool felt = false;
        for (const double value : {errors[category].low, errors[category].high}) {
            double end = frame.values.at(value);
            const bool at_axis = std::abs(end - zero) < least_;
            if (at_axis) end = zero;
            if (std::abs(end - tip) < least_ || (at_axis && std::abs(tip - zero) < least_)) continue;
            felt = true;
            drawing_.strokes.push_back({{at(frame, middle, tip), at(frame, middle, end)}, false, LineClass::thin});
            if (at_axis)
                ++at_axis_;
            else
                drawing_.strokes.push_back(
                    {{at(frame, middle - cap, end), at(frame, middle + cap, end)}, false, LineClass::thin});
        }
        if (!felt && errors[category].low < errors[category].high) ++small_errors_;
    }

    void draw_grid_of(const BarFrame& frame) {
        const Rect& field = frame.field;
        std::vector<std::pair<Point, Point>> lines;
        for (const double tick : frame.values.ticks()) {
            const double at = frame.values.at(tick);
            if (frame.level)
                lines.push_back({{at, field.top + field.height}, {at, field.top}});
            else
                lines.push_back({{field.left, at}, {field.left + field.width, at}});
        }
        draw_grid(drawing_, lines, bar_boxes_, medium_);
    }

    void tell(const BarFrame& frame) {
        told_.level = frame.level;
        (frame.level ? told_.x : told_.y) = frame.values.place();
        if (unknown_ > 0)
            notes_.push_back(phrases(unknown_, "{0} value is not known, and there is no bar for it",
                                     "{0} values are not known, and there is no bar for them"));
        if (short_ > 0)
            notes_.push_back(phrases(short_, "{0} bar is shorter than {1} mm and drawn as a solid strip along the axis",
                                     "{0} bars are shorter than {1} mm and drawn as a solid strip along the axis",
                                     numeral(std::round(10 * least_) / 10)));
        if (left_out_ > 0)
            notes_.push_back(to_act_on(phrases(
                left_out_,
                "{0} part of a stack is too low to be felt and counted with the larger one beside it; larger paper shows more",
                "{0} parts of stacks are too low to be felt and counted with the larger one beside it; larger paper shows "
                "more")));
        if (low_ > 0 && bars_.series.size() > 1)
            notes_.push_back(
                to_act_on(phrases(low_, "{0} bar is so low that a finger may not know the texture; larger paper shows more",
                                  "{0} bars are so low that a finger may not know the texture; larger paper shows more")));
        if (at_axis_ > 0)
            notes_.push_back(phrases(at_axis_, "{0} error ends near the axis and is drawn up to it",
                                     "{0} errors end near the axis and are drawn up to it"));
        if (small_errors_ > 0)
            notes_.push_back(phrases(small_errors_, "{0} error is smaller than a finger tells and left out",
                                     "{0} errors are smaller than a finger tells and left out"));
    }

    const Plot& plot_;
    const PlotBars& bars_;
    const Sheet& sheet_;
    const Medium& medium_;
    const ChartWish& wish_;
    Notes& notes_;
    ChartTold& told_;
    const Clearance clear_;
    const Place place_;
    const CellPlaces cells_;
    const double least_;  // mm from the middle of a line to that of another
    std::vector<Rect> bar_boxes_;
    bool has_errors_ = false;
    std::size_t unknown_ = 0, short_ = 0, left_out_ = 0, low_ = 0, small_errors_ = 0, at_axis_ = 0;
    Drawing drawing_;
};

}  // namespace

Drawing draw_bars(const Plot& plot, const Sheet& sheet, const ChartWish& wish, Notes& notes, ChartTold& told) {
    return BarChart(plot, sheet, wish, notes, told).draw();
}

}  // namespace tactics
