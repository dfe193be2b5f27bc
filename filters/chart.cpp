#include "filters/chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "filters/ticks.h"
#include "tactics/error.h"
#include "tactics/label.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kTick = 4;        // mm: longer than a line is wide, so that it is felt as a tick
constexpr double kClear = 3.2;     // mm between things that are not to touch: the gap of swell paper
constexpr double kLines = 3.5;     // mm between blocks of words: lines of braille are 10 mm apart
constexpr double kMark = 2.2;      // mm, radius of a mark: clearly larger than a braille dot
constexpr int kMostTicks = 6;      // an axis
constexpr double kLeastSide = 50;  // mm; a smaller field of data cannot be read by touch

// From values to millimetres along one axis.
class Scale {
public:
    Scale(const Axis& axis, double low, double high, int most_ticks, double from, double to)
        : logarithmic_(axis.logarithmic), ticks_(ticks_for(low, high, axis.logarithmic, most_ticks)), from_(from), to_(to) {}

    double at(double value) const {
        const double first = bent(ticks_.front()), last = bent(ticks_.back());
        return from_ + (bent(value) - first) / (last - first) * (to_ - from_);
    }
    const std::vector<double>& ticks() const { return ticks_; }

private:
    double bent(double value) const { return logarithmic_ ? std::log10(value) : value; }
    bool logarithmic_;
    std::vector<double> ticks_;
    double from_, to_;
};

struct Range {
    double low = INFINITY, high = -INFINITY;
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

bool overlap(const Rect& a, const Rect& b) {
    return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height;
}

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

class Chart {
public:
    Chart(const Plot& plot, const Sheet& sheet, double width, double height) : plot_(plot), sheet_(sheet) {
        drawing_.width = width;
        drawing_.height = height;
    }

    Drawing draw() {
        const Range x = range_of(&PlotMark::x, &PlotPoint::x), y = range_of(&PlotMark::y, &PlotPoint::y);
        const double bottom = draw_key();
        // The ticks' words decide how much room is left; an upright block of words is about as high as 12 mm.
        const LabelBlock name_y = set_label(plot_.y.name, sheet_), name_x = set_label(plot_.x.name, sheet_);
        double words_y = 0, words_x = 0, height_x = 0, height_y = 0;
        for (const double tick : ticks_for(y.low, y.high, plot_.y.logarithmic, kMostTicks)) {
            const LabelBlock words = set_label(to_text(tick), sheet_);
            words_y = std::max(words_y, words.width);
            height_y = std::max(height_y, words.height);
        }
        for (const double tick : ticks_for(x.low, x.high, plot_.x.logarithmic, kMostTicks)) {
            const LabelBlock words = set_label(to_text(tick), sheet_);
            words_x = std::max(words_x, words.width);
            height_x = std::max(height_x, words.height);
        }
        // Half of the lowest tick's words hang below the axis.
        below_axis_ = std::max(kTick, height_y / 2) + kClear / 2;
        field_.left = words_y + kClear + kTick;
        field_.top = name_y.height + height_y / 2 + kLines;
        field_.width = drawing_.width - words_x / 2 - field_.left;
        field_.height = bottom - name_x.height - height_x - 2 * kLines - below_axis_ - field_.top;
        if (field_.width < kLeastSide || field_.height < kLeastSide)
            throw Error(Fault::usage, "", "the chart does not fit on this paper; take larger paper, or fewer things to compare");
        const auto most = [](double length, double words) {
            return std::clamp(static_cast<int>(length / (words + kClear)) + 1, 3, kMostTicks);
        };
        const Scale across(plot_.x, x.low, x.high, most(field_.width, words_x), field_.left, field_.left + field_.width);
        const Scale up(plot_.y, y.low, y.high, most(field_.height, height_y), field_.top + field_.height, field_.top);
        draw_axes(across, up);
        draw_data(across, up);
        label({0, 0}, 0, 0, plot_.y.name);
        label({field_.left + field_.width, field_.top + field_.height + below_axis_ + height_x + kLines}, 1, 0, plot_.x.name);
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

    void label(Point at, double across, double down, const std::string& text) {
        if (!text.empty()) drawing_.labels.push_back({at, across, down, text});
    }

    // The key stands at the bottom, in as many columns as it has room for. Gives where it begins.
    double draw_key() {
        std::vector<std::string> lines;
        for (const PlotCurve& curve : plot_.curves)
            if (!curve.name.empty()) lines.push_back(letter_of(lines.size()) + " " + curve.name);
        for (const PlotMark& mark : plot_.marks) lines.push_back(letter_of(lines.size()) + " " + mark.name);
        double width = 0, height = 0;
        for (const std::string& line : lines) {
            const LabelBlock block = set_label(line, sheet_);
            width = std::max(width, block.width);
            height = std::max(height, block.height);
        }
        constexpr double kBetweenColumns = 12;  // two cells: a blank that no word has
        const double columns = std::max(1.0, std::floor((drawing_.width + kBetweenColumns) / (width + kBetweenColumns)));
        const double rows = std::ceil(static_cast<double>(lines.size()) / columns);
        const double pitch = height + kLines, top = drawing_.height - rows * pitch;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double column = std::floor(static_cast<double>(i) / rows), row = static_cast<double>(i) - column * rows;
            label({column * (width + kBetweenColumns), top + row * pitch + kLines}, 0, 0, lines[i]);
        }
        return top;
    }

    void line(std::vector<Point> points, LineClass width) { drawing_.strokes.push_back({std::move(points), false, width, 0}); }

    void draw_axes(const Scale& across, const Scale& up) {
        const double bottom = field_.top + field_.height;
        line({{field_.left, field_.top}, {field_.left, bottom}, {field_.left + field_.width, bottom}}, LineClass::thin);
        for (const double tick : across.ticks()) {
            line({{across.at(tick), bottom}, {across.at(tick), bottom + kTick}}, LineClass::thin);
            label({across.at(tick), bottom + below_axis_}, 0.5, 0, to_text(tick));
        }
        for (const double tick : up.ticks()) {
            line({{field_.left - kTick, up.at(tick)}, {field_.left, up.at(tick)}}, LineClass::thin);
            label({field_.left - kTick - kClear / 2, up.at(tick)}, 1, 0.5, to_text(tick));
        }
    }

    void draw_data(const Scale& across, const Scale& up) {
        std::vector<Point> centres;
        std::vector<Rect> taken;
        for (const PlotMark& mark : plot_.marks) {
            centres.push_back({across.at(mark.x), up.at(mark.y)});
            taken.push_back({centres.back().x - kMark, centres.back().y - kMark, 2 * kMark, 2 * kMark});
        }
        std::size_t letter = 0;
        for (const PlotCurve& curve : plot_.curves) {
            std::vector<Point> points;
            for (const PlotPoint& point : curve.points) points.push_back({across.at(point.x), up.at(point.y)});
            if (!curve.name.empty() && !points.empty()) put_letter(letter_of(letter++), points.back(), taken);
            if (points.size() > 1) line(std::move(points), LineClass::normal);
        }
        for (std::size_t i = 0; i < plot_.marks.size(); ++i) {
            if (plot_.marks[i].filled)
                drawing_.areas.push_back({{circle(centres[i], kMark)}});
            else
                drawing_.strokes.push_back({circle(centres[i], kMark), true, LineClass::thin, 0});
            put_letter(letter_of(letter++), centres[i], taken);
        }
    }

    // Beside its place, on the first side where nothing is.
    void put_letter(const std::string& letter, Point at, std::vector<Rect>& taken) {
        const LabelBlock block = set_label(letter, sheet_);
        Rect best{};
        double fewest = INFINITY;
        for (double away = kMark + kClear / 2; away < 8 * kMark; away += kMark) {
            for (const auto& [right, down] : {std::pair{0.0, -1.0}, {1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.7, -0.7}, {-0.7, -0.7}, {0.7, 0.7}, {-0.7, 0.7}}) {
                const Rect place{at.x + right * (away + block.width / 2) - block.width / 2,
                                 at.y + down * (away + block.height / 2) - block.height / 2, block.width, block.height};
                double faults = away / 100;
                for (const Rect& other : taken) faults += overlap(place, other) ? 1 : 0;
                for (const Stroke& stroke : drawing_.strokes) faults += crosses(stroke, place) ? 0.5 : 0;
                const bool outside = place.left < field_.left + kClear / 2 || place.top < 0 || place.left + place.width > drawing_.width ||
                                     place.top + place.height > field_.top + field_.height - kClear / 2;
                faults += outside ? 2 : 0;
                if (faults < fewest) {
                    fewest = faults;
                    best = place;
                }
            }
        }
        taken.push_back(best);
        label({best.left, best.top}, 0, 0, letter);
    }

    // Whether a side of the line comes into the box, by samples a millimetre apart.
    static bool crosses(const Stroke& stroke, const Rect& box) {
        for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
            const Point a = stroke.points[i], b = stroke.points[i + 1];
            const int steps = static_cast<int>(std::hypot(b.x - a.x, b.y - a.y)) + 1;
            for (int k = 0; k <= steps; ++k) {
                const double x = a.x + (b.x - a.x) * k / steps, y = a.y + (b.y - a.y) * k / steps;
                if (x > box.left && x < box.left + box.width && y > box.top && y < box.top + box.height) return true;
            }
        }
        return false;
    }

    const Plot& plot_;
    const Sheet& sheet_;
    Drawing drawing_;
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
