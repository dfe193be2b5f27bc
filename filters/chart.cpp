#include "filters/chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "filters/ticks.h"
#include "tactics/error.h"
#include "tactics/label.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kTick = 6.35;                   // mm on each side of the axis: 1/4 in (rules/tick_sides.cpp)
constexpr double kClear = 3.2;                   // mm between things that are not to touch: the gap of swell paper
constexpr double kLines = 3.5;                   // mm between blocks of words: lines of braille are 10 mm apart
constexpr double kWords = 8;                     // mm between words in a line: an empty cell; with less two words are read as one
constexpr int kFewestTicks = 3, kMostTicks = 6;  // an axis
constexpr double kLeastSide = 50;                // mm; a smaller field of data cannot be read by touch
constexpr double kLead = 8;                      // mm; words farther from their mark are led to it by a line
constexpr double kNearer = 2.5;                  // mm that words are nearer to their mark than to any other
constexpr double kFarthest = 80;                 // mm from a mark to its words

// How things keep clear of words. An embosser sets words in whole cells, up to half a cell off, and chains of dots up to
// half the gap between cells or lines off.
struct Clearance {
    double across = 0;  // words to the middle of a thin line, mm
    double down = 0;
    double words = 0;  // words to words beside them
    double mark = 0;   // radius: clearly larger than a braille dot (rules/symbol_size.cpp)
};
Clearance clearance_on(const Medium& medium) {
    const double line = medium.thin_line / 2;  // a line is as much wider on either side
    if (medium.name != "embosser") return {kClear + line, kClear + line, kWords, 2.5};
    return {kClear + 3.0 + 2.6, kClear + 5.0, kWords + 6.0, 4.0};  // a disc is to be felt as one, and a ring as hollow
}

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

double gap_between(double from, double size, double other_from, double other_size) {
    return std::max({0.0, other_from - from - size, from - other_from - other_size});
}

// How far the line is from the box, by samples half a millimetre apart; 0 where it comes in. A side farther than `enough`
// is not looked at closely.
double room_between(const Rect& box, const std::vector<Point>& line, double enough) {
    double least = INFINITY;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point a = line[i], b = line[i + 1];
        if (std::hypot(gap_between(box.left, box.width, std::min(a.x, b.x), std::abs(a.x - b.x)),
                       gap_between(box.top, box.height, std::min(a.y, b.y), std::abs(a.y - b.y))) > enough)
            continue;
        const int steps = static_cast<int>(2 * distance(a, b)) + 1;
        for (int k = 0; k <= steps; ++k)
            least = std::min(least, std::hypot(gap_between(box.left, box.width, a.x + (b.x - a.x) * k / steps, 0),
                                               gap_between(box.top, box.height, a.y + (b.y - a.y) * k / steps, 0)));
    }
    return least;
}

Rect grown(const Rect& box, double across, double down) {
    return {box.left - across, box.top - down, box.width + 2 * across, box.height + 2 * down};
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
        below_axis_ = std::max(kTick + clear_.down, height_y / 2 + kLines);
        top_ = name_y.height;
        field_.left = words_y + clear_.across + kTick;
        field_.top = top_ + height_y / 2 + kLines;
        field_.width = drawing_.width - words_x / 2 - field_.left;
        field_.height = bottom - name_x.height - height_x - 2 * kLines - below_axis_ - field_.top;
        // A letter has room over the highest mark.
        const double over = set_label("m", sheet_).height + clear_.mark + clear_.down + kLines - (field_.top - top_);
        if (field_.width < kLeastSide || field_.height < kLeastSide + over)
            throw Error(Fault::usage, "", "the chart does not fit on this paper; take larger paper, or fewer things to compare");
        // No mark touches an axis or its ticks, or leaves the drawing.
        const double inset = kTick + clear_.mark + kClear, edge = clear_.mark + sheet_.medium->thin_line;
        const Scale across = scale(plot_.x, x, field_.left + inset, field_.left + field_.width - edge, false);
        const Scale up = scale(plot_.y, y, field_.top + field_.height - inset, field_.top + std::max(edge, over), true);
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

    // With as many ticks as their words have room for.
    Scale scale(const Axis& axis, const Range& range, double from, double to, bool upright) const {
        const auto room = [&](double tick) {
            const LabelBlock words = set_label(to_text(tick), sheet_);
            return upright ? words.height + kLines : words.width + clear_.words;
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
        const double pitch = height + kLines, top = drawing_.height - rows * pitch;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double column = std::floor(static_cast<double>(i) / rows), row = static_cast<double>(i) - column * rows;
            label({column * (width + between), top + row * pitch + kLines}, 0, 0, lines[i]);
        }
        return top;
    }

    void line(std::vector<Point> points, LineClass width, Role role = Role::line) {
        drawing_.strokes.push_back({std::move(points), false, width, 0, role});
    }

    void draw_axes(const Scale& across, const Scale& up) {
        const double bottom = field_.top + field_.height;
        line({{field_.left, field_.top}, {field_.left, bottom}, {field_.left + field_.width, bottom}}, LineClass::thin, Role::axis);
        for (const double tick : across.ticks()) {
            line({{across.at(tick), bottom - kTick}, {across.at(tick), bottom + kTick}}, LineClass::thin, Role::tick);
            label({across.at(tick), bottom + below_axis_}, 0.5, 0, to_text(tick));
        }
        for (const double tick : up.ticks()) {
            line({{field_.left - kTick, up.at(tick)}, {field_.left + kTick, up.at(tick)}}, LineClass::thin, Role::tick);
            label({field_.left - kTick - clear_.across, up.at(tick)}, 1, 0.5, to_text(tick));
        }
    }

    struct Tag {
        Point at;
        std::string letter;
        LabelBlock block;
        Rect place{};
        bool placed = false;
    };

    void draw_data(const Scale& across, const Scale& up) {
        std::vector<Tag> tags;
        const auto tag = [&](Point at) {
            const std::string letter = letter_of(tags.size());
            tags.push_back({at, letter, set_label(letter, sheet_)});
        };
        for (const PlotCurve& curve : plot_.curves) {
            std::vector<Point> points;
            for (const PlotPoint& point : curve.points) points.push_back({across.at(point.x), up.at(point.y)});
            if (!curve.name.empty() && !points.empty()) tag(points.back());
            if (points.size() > 1) line(std::move(points), LineClass::normal);
        }
        for (const PlotMark& mark : plot_.marks) {
            const Point at{across.at(mark.x), up.at(mark.y)};
            if (!mark.name.empty()) tag(at);
            marks_.push_back(at);
            if (mark.filled)
                drawing_.areas.push_back({{circle(at, clear_.mark)}, Role::symbol});
            else
                drawing_.strokes.push_back({circle(at, clear_.mark), true, LineClass::thin, 0, Role::symbol});
        }
        place_letters(tags);
        for (const Tag& one : tags) {
            if (const auto lead = lead_of(one.at, one.place); !lead.empty()) line(lead, LineClass::thin, Role::lead);
            label({one.place.left, one.place.top}, 0, 0, one.letter);
        }
    }

    // From the mark to its words, if they are far; it keeps clear of them, too.
    std::vector<Point> lead_of(Point at, const Rect& box) const {
        const Rect kept = grown(box, clear_.across, clear_.down);
        const Point end{std::clamp(at.x, kept.left, kept.left + kept.width), std::clamp(at.y, kept.top, kept.top + kept.height)};
        const double length = distance(at, end);
        if (length < clear_.mark + kLead) return {};
        return {{at.x + (end.x - at.x) * clear_.mark / length, at.y + (end.y - at.y) * clear_.mark / length}, end};
    }

    // Whoever comes first takes the best place, so several orders are tried.
    void place_letters(std::vector<Tag>& tags) const {
        constexpr int kOrders = 6, kRounds = 2;
        constexpr double kGood = 0.25;  // a lead and no fault
        std::vector<std::size_t> order(tags.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = order.size() - 1 - i;
        std::minstd_rand random(1);
        std::vector<Tag> best;
        double fewest = INFINITY;
        for (int k = 0; k < kOrders && fewest > kGood * static_cast<double>(tags.size()); ++k) {
            std::vector<Tag> tried = tags;
            for (int round = 0; round < kRounds; ++round)  // who was first looks again when all others have their place
                for (const std::size_t i : order) place_letter(tried[i], tried);
            double faults = 0;
            for (const Tag& tag : tried)
                faults += faults_of(tag, tag.place, tried, INFINITY) + distance(tag.at, {tag.place.left, tag.place.top}) / 100;
            if (faults < fewest) {
                fewest = faults;
                best = tried;
            }
            for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
        }
        if (!best.empty()) tags = std::move(best);
    }

    // In the free place nearest to what it is about.
    void place_letter(Tag& tag, const std::vector<Tag>& tags) const {
        constexpr int kDirections = 24;
        constexpr double kStep = 1.5;  // mm
        double fewest = INFINITY;
        Rect best{};
        for (double away = 0.1; away < kFarthest && away / 100 < fewest; away += kStep)
            for (int i = 0; i < kDirections; ++i) {
                // Upwards first.
                const double angle = 2 * std::numbers::pi * i / kDirections, right = std::sin(angle), down = -std::cos(angle);
                const double reach_x = clear_.mark + clear_.across + away + tag.block.width / 2;
                const double reach_y = clear_.mark + clear_.down + away + tag.block.height / 2;
                // On the outline of a box around the mark rather than on a circle: words are wide.
                const double most = std::max(std::abs(right), std::abs(down));
                const Rect place{tag.at.x + right / most * reach_x - tag.block.width / 2,
                                 tag.at.y + down / most * reach_y - tag.block.height / 2, tag.block.width, tag.block.height};
                const double faults = faults_of(tag, place, tags, fewest) + away / 100;
                if (faults >= fewest) continue;
                fewest = faults;
                best = place;
            }
        tag.place = best;
        tag.placed = true;
    }

    // Whether a lead crosses a curve, or ends on it; near its own mark it may begin on one.
    static bool comes_to(const std::vector<Point>& lead, const std::vector<Point>& curve) {
        const double length = distance(lead.front(), lead.back());
        for (double along = kClear; along <= length; along += 0.5) {
            const double share = along / length;
            const Rect point{lead.front().x + share * (lead.back().x - lead.front().x),
                             lead.front().y + share * (lead.back().y - lead.front().y), 0, 0};
            if (room_between(point, curve, 1.5) < 1.5) return true;
        }
        return false;
    }

    // What would be wrong with these words there: each fault counts more than any distance.
    // From `enough` on it does not matter how much.
    double faults_of(const Tag& tag, const Rect& place, const std::vector<Tag>& tags, double enough) const {
        constexpr double kTouches = 3;  // words can no longer be read; a line that crosses another still leads
        double faults = 0;
        const double curve = (sheet_.medium->line - sheet_.medium->thin_line) / 2;  // what it is wider than a thin line
        if (place.left < field_.left + kTick + clear_.across || place.top < top_ + kLines || place.left + place.width > drawing_.width ||
            place.top + place.height > field_.top + field_.height - kTick - clear_.down)
            faults += 5;
        if (faults >= enough) return faults;
        const Rect kept = grown(place, clear_.across, clear_.down);
        const std::vector<Point> lead = lead_of(tag.at, place);
        for (const Point& mark : marks_) {
            const double radius = clear_.mark;
            if (room_between(kept, {mark, mark}, radius) < radius) faults += kTouches;
            // Without a line a finger takes the nearest mark.
            if (lead.empty() && distance(mark, tag.at) > 0 &&
                room_between(place, {mark, mark}, kFarthest) < room_between(place, {tag.at, tag.at}, kFarthest) + kNearer)
                faults += 0.5;
            const double clear = std::min(radius + kClear, distance(mark, tag.at));
            if (!lead.empty() && clear > 0 && room_between({mark.x, mark.y, 0, 0}, lead, clear) < clear) faults += 0.7;
        }
        for (const Tag& other : tags) {
            if (&other == &tag || !other.placed) continue;
            const Rect& box = other.place;
            if (gap_between(place.left, place.width, box.left, box.width) < clear_.words &&
                gap_between(place.top, place.height, box.top, box.height) < kLines)
                faults += kTouches;
            const Rect other_kept = grown(box, clear_.across, clear_.down);
            if (!lead.empty() && room_between(other_kept, lead, 0) <= 0) faults += kTouches;
            if (const auto theirs = lead_of(other.at, box); !theirs.empty() && room_between(kept, theirs, 0) <= 0)
                faults += kTouches;
        }
        if (faults >= enough) return faults;
        for (const Stroke& stroke : drawing_.strokes) {
            if (stroke.closed || stroke.line == LineClass::thin) continue;
            if (room_between(kept, stroke.points, curve) <= curve) faults += kTouches;
            if (!lead.empty() && comes_to(lead, stroke.points)) faults += 1;
        }
        return faults + (lead.empty() ? 0 : 0.2);
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
