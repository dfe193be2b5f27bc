// SPDX-License-Identifier: Apache-2.0
#include "filters/bar_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/chart_key.h"
#include "tactics/error.h"

namespace tactics {

namespace {

constexpr double kLeastLength = 40;    // mm of the axis of values; with less, bars that differ cannot be told apart
constexpr double kMostNames = 0.4;     // of the width, for the names beside level bars
constexpr std::size_t kMostLines = 3;  // of a name below a bar
// mm below a name, whose print is above its braille, so that lines of braille are farther from each other than in a text.
constexpr double kBelowName = 1;
constexpr double kFrameRounding = 1e-6;  // mm

using Lines = std::vector<std::string>;

// Nothing if one of the names is wider or higher than its room.
std::optional<std::vector<Lines>> names_within(const std::vector<std::string>& names, double width, double height,
                                               std::size_t most_lines, const Sheet& sheet) {
    std::vector<Lines> all;
    for (const std::string& name : names) {
        Lines lines = lines_within(name, width, sheet);
        const bool fits = std::all_of(lines.begin(), lines.end(), [&](const std::string& line) {
            return set_label(line, sheet).width <= width + kFrameRounding;
        });
        if (!fits || lines.size() > most_lines || height_of(lines, sheet) > height) return std::nullopt;
        all.push_back(std::move(lines));
    }
    return all;
}

double highest(const std::vector<Lines>& names, const Sheet& sheet) {
    double height = 0;
    for (const Lines& lines : names) height = std::max(height, height_of(lines, sheet));
    return height;
}

double widest(const std::vector<Lines>& names, const Sheet& sheet) {
    double width = 0;
    for (const Lines& lines : names)
        for (const std::string& line : lines) width = std::max(width, set_label(line, sheet).width);
    return width;
}

// A frame while its parts are found.
class BarFraming {
public:
    BarFraming(const Plot& plot, const std::vector<std::string>& names, BarLook look, const BarRoom& room)
        : plot_(plot),
          names_(names),
          look_(look),
          room_(room),
          medium_(*room.sheet.medium),
          extent_(extent_of_bars(*plot.bars)),
          words_(widest_words(plot.y, extent_, room.sheet)) {}

    std::optional<BarFrame> upright() const {
        const Sheet& sheet = room_.sheet;
        const Lines name_x = lines_within(plot_.x.name, room_.width, sheet),
                    name_y = lines_within(plot_.y.name, room_.width, sheet);
        Rect field;
        field.left = words_.width + room_.clear.across + kChartTick;
        field.top = height_of(name_y, sheet) + words_.height / 2 + kChartLines;
        field.width = room_.width - edge() - field.left;
        const double pitch = room_.cells.cell_pitch();
        const auto places =
            bars_on(field.width - inset() - pitch, names_.size(), count_of_bars(), look_, medium_, {pitch, false});
        if (!places) return std::nullopt;
        const double begins = places->begin_of(0, 0);
        const double first = room_.cells.next_cell({field.left + inset() + begins, 0}).x - begins;
        const auto names = names_within(names_, places->slot - room_.clear.words, INFINITY, kMostLines, sheet);
        if (!names) return std::nullopt;
        const double below = std::max(room_.clear.down, words_.height / 2 + kChartLines), words = highest(*names, sheet);
        const double name_height = height_of(name_x, sheet);
        field.height = room_.bottom - name_height - words - (name_height > 0 ? 2 : 1) * kChartLines - below - field.top;
        if (field.height < kLeastLength) return std::nullopt;
        const double bottom = field.top + field.height;
        const AxisRoom values{extent_.low < 0 ? bottom - edge() : bottom, field.top + edge(), true, 0, room_.width};
        return BarFrame{false,  field, first, *places, scale_for(plot_.y, extent_, values, sheet), *names, name_x,
                        name_y, 0,     below, words};
    }

    std::optional<BarFrame> level() const {
        const Sheet& sheet = room_.sheet;
        const Lines name_x = lines_within(plot_.y.name, room_.width, sheet),
                    name_y = lines_within(plot_.x.name, room_.width, sheet);
        const auto in_lines = names_within(names_, kMostNames * room_.width, INFINITY, names_.size() + kMostLines, sheet);
        if (!in_lines) return std::nullopt;
        const double below = kChartTick + room_.clear.down;
        Rect field;
        field.left = widest(*in_lines, sheet) + beside_names();
        field.top = height_of(name_y, sheet) + std::max(kChartLines, room_.clear.down);
        field.width = room_.width - words_.width / 2 - field.left;
        field.height = room_.bottom - height_of(name_x, sheet) - words_.height - 2 * kChartLines - below - field.top;
        if (field.width < kLeastLength || !(field.height > inset())) return std::nullopt;
        const double pitch = room_.cells.anywhere() ? 0 : room_.cells.line_pitch();
        const auto places =
            bars_on(field.height - inset() - pitch, names_.size(), count_of_bars(), look_, medium_, {pitch, pitch > kTwoRows});
        if (!places || std::max(highest(*in_lines, sheet) + kBelowName, sheet.cell.line_pitch) > places->slot + kFrameRounding)
            return std::nullopt;
        const double begins = places->begin_of(0, 0);
        const double first = room_.cells.next_cell({0, field.top + begins}).y - begins;
        const AxisRoom values{extent_.low < 0 ? field.left + edge() : field.left, field.left + field.width - edge(), false,
                              room_.clear.words, room_.width};
        return BarFrame{true,
                        field,
                        first,
                        *places,
                        scale_for(plot_.y, extent_, values, sheet),
                        *in_lines,
                        name_x,
                        name_y,
                        widest(*in_lines, sheet),
                        below,
                        words_.height};
    }

private:
    std::size_t count_of_bars() const { return plot_.bars->stacked ? 1 : plot_.bars->series.size(); }
    double edge() const { return medium_.thick_line / 2 + kChartClear; }
    // From names to the axis, at which wider lines of bars end.
    double beside_names() const { return room_.clear.across + (medium_.line - medium_.thin_line) / 2; }
    // Bars begin clear of the ticks, which reach into the field.
    double inset() const { return kChartTick + kChartClear + medium_.thin_line; }

    const Plot& plot_;
    const std::vector<std::string>& names_;
    const BarLook look_;
    const BarRoom& room_;
    const Medium& medium_;
    const AxisExtent extent_;
    const LabelBlock words_;
};

// Level where level bars have them: below each other around `middle`; else from `top` down.
void write(const Lines& lines, Point at, double across, const Sheet& sheet, Drawing& drawing) {
    for (const std::string& text : lines) {
        if (text.empty()) continue;
        drawing.labels.push_back({at, across, 0, text});
        at.y += set_label(text, sheet).height + kChartLines;
    }
}

}  // namespace

AxisExtent extent_of_bars(const PlotBars& bars) {
    AxisExtent extent;
    extent.take(0);
    for (std::size_t i = 0; i < bars.categories.size(); ++i) {
        double up = 0, down = 0;  // of a stack
        for (const PlotSeries& series : bars.series) {
            const double value = series.values[i];
            if (std::isnan(value)) continue;
            (value < 0 ? down : up) += value;
            extent.take(bars.stacked ? (value < 0 ? down : up) : value);
            if (series.errors.empty() || std::isnan(series.errors[i].low)) continue;
            extent.take(series.errors[i].low);
            extent.take(series.errors[i].high);
        }
    }
    if (extent.low == extent.high) extent.take(1);  // nothing but 0: an axis up to 1 shows that there are no bars
    return extent;
}

std::optional<BarFrame> bar_frame(const Plot& plot, const std::vector<std::string>& names, bool level, BarLook look,
                                  const BarRoom& room) {
    const BarFraming framing(plot, names, look, room);
    return level ? framing.level() : framing.upright();
}

void draw_bar_frame(const BarFrame& frame, const BarRoom& room, Drawing& drawing) {
    const Rect& field = frame.field;
    const Sheet& sheet = room.sheet;
    const double right = field.left + field.width, bottom = field.top + field.height, zero = frame.values.at(0);
    const auto line = [&](std::vector<Point> points, Role role) {
        drawing.strokes.push_back({std::move(points), false, LineClass::thin, 0, role});
    };
    // One line where bars begin at the corner of the axes; else one along the values and one at 0.
    const Point corner{field.left, bottom};
    const Point up{field.left, field.top}, across{right, bottom};
    if (frame.level ? zero <= field.left + kFrameRounding : zero >= bottom - kFrameRounding) {
        line({up, corner, across}, Role::axis);
    } else {
        line(frame.level ? std::vector<Point>{corner, across} : std::vector<Point>{up, corner}, Role::axis);
        line(frame.level ? std::vector<Point>{{zero, field.top}, {zero, bottom}}
                         : std::vector<Point>{{field.left, zero}, {right, zero}},
             Role::axis);
    }
    for (std::size_t i = 0; i < frame.values.ticks().size(); ++i) {
        const double at = frame.values.at(frame.values.ticks()[i]);
        const double inner = std::abs(at - zero) < kFrameRounding ? 0 : kChartTick;  // at 0 the axis of the bars goes on from it
        const std::string& words = frame.values.words()[i];
        if (frame.level) {
            line({{at, bottom - inner}, {at, bottom + kChartTick}}, Role::tick);
            drawing.labels.push_back({{at, bottom + frame.below}, frame.values.before()[i], 0, words});
        } else {
            line({{field.left - kChartTick, at}, {field.left + inner, at}}, Role::tick);
            drawing.labels.push_back({{field.left - kChartTick - room.clear.across, at}, 1, 0.5, words});
        }
    }
    for (std::size_t i = 0; i < frame.names.size(); ++i) {
        const double middle = frame.first + (static_cast<double>(i) + 0.5) * frame.places.slot;
        if (frame.level)
            write(frame.names[i], {frame.names_end, middle - height_of(frame.names[i], sheet) / 2}, 1, sheet, drawing);
        else
            write(frame.names[i], {middle, bottom + frame.below}, 0.5, sheet, drawing);
    }
    write(frame.name_y, {0, 0}, 0, sheet, drawing);
    write(frame.name_x, {right, bottom + frame.below + frame.words + kChartLines}, 1, sheet, drawing);
}

}  // namespace tactics
