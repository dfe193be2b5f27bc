// SPDX-License-Identifier: Apache-2.0
#include "filters/chart_letters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tactics {

namespace {

constexpr double kLead = 8;              // mm; words farther from their mark are led to it by a line
constexpr double kNearer = 2.5;          // mm that words are nearer to their mark than to any other
constexpr double kFarthestWords = 80;    // mm from a mark to its words
constexpr double kLetterRounding = 0.2;  // mm: lines of braille 10 mm apart are far enough, on paper and in cells

double gap_between(double from, double size, double other_from, double other_size) {
    return std::max({0.0, other_from - from - size, from - other_from - other_size});
}

// How far the line is from the box, by samples half a millimetre apart; 0 where it comes in. A side farther than `enough`
// is not looked at closely.
double room_between(const Rect& box, const std::vector<Point>& line, double enough) {
    const auto square = [&](double x, double wide, double y, double high) {
        const double across = gap_between(box.left, box.width, x, wide), down = gap_between(box.top, box.height, y, high);
        return across * across + down * down;
    };
    double least = INFINITY;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point a = line[i], b = line[i + 1];
        if (square(std::min(a.x, b.x), std::abs(a.x - b.x), std::min(a.y, b.y), std::abs(a.y - b.y)) > enough * enough) continue;
        const int steps = static_cast<int>(2 * distance(a, b)) + 1;
        for (int k = 0; k <= steps; ++k)
            least = std::min(least, square(a.x + (b.x - a.x) * k / steps, 0, a.y + (b.y - a.y) * k / steps, 0));
    }
    return std::sqrt(least);
}

Rect grown(const Rect& box, double across, double down) {
    return {box.left - across, box.top - down, box.width + 2 * across, box.height + 2 * down};
}

// It begins at the edge of a mark, `begins` from its middle, or on a curve.
std::vector<Point> lead_between(Point at, const Rect& box, const Clearance& clear, double begins) {
    const Rect kept = grown(box, clear.across, clear.down);
    const Point end{std::clamp(at.x, kept.left, kept.left + kept.width), std::clamp(at.y, kept.top, kept.top + kept.height)};
    const double length = distance(at, end);
    if (length < clear.mark + kLead) return {};
    return {{at.x + (end.x - at.x) * begins / length, at.y + (end.y - at.y) * begins / length}, end};
}

double begins_at(const ChartTag& tag, const Clearance& clear) { return tag.curve.empty() ? clear.mark : 0; }

// Whether a lead crosses a curve, or ends on it; near its own mark it may begin on one.
bool comes_to(const std::vector<Point>& lead, const std::vector<Point>& curve) {
    const double length = distance(lead.front(), lead.back());
    for (double along = kChartClear; along <= length; along += 0.5) {
        const double share = along / length;
        const Rect point{lead.front().x + share * (lead.back().x - lead.front().x),
                         lead.front().y + share * (lead.back().y - lead.front().y), 0, 0};
        if (room_between(point, curve, 1.5) < 1.5) return true;
    }
    return false;
}

class Letters {
public:
    explicit Letters(const ChartGround& ground) : ground_(ground), clear_(ground.clear) {}

    // Whoever comes first takes the best place, so several orders are tried.
    void place_all(std::vector<ChartTag>& tags) const {
        constexpr int kOrders = 6, kRounds = 2;
        constexpr double kGood = 0.25;  // a lead and no fault
        std::vector<std::size_t> order(tags.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = order.size() - 1 - i;
        std::minstd_rand random(1);
        std::vector<ChartTag> best;
        double fewest = INFINITY;
        for (int k = 0; k < kOrders && fewest > kGood * static_cast<double>(tags.size()); ++k) {
            std::vector<ChartTag> tried = tags;
            for (int round = 0; round < kRounds; ++round)  // who was first looks again when all others have their place
                for (const std::size_t i : order) place(tried[i], tried);
            double faults = 0;
            for (const ChartTag& tag : tried)
                faults +=
                    faults_of(tag, tag.at, tag.place, tried, INFINITY) + distance(tag.at, {tag.place.left, tag.place.top}) / 100;
            if (faults < fewest) {
                fewest = faults;
                best = tried;
            }
            for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
        }
        if (!best.empty()) tags = std::move(best);
    }

private:
    // In the free place nearest to what it is about.
    void place(ChartTag& tag, const std::vector<ChartTag>& tags) const {
        constexpr int kDirections = 24;
        constexpr double kStep = 1.5;  // mm
        double fewest = INFINITY;
        Rect best{};
        Point best_at = tag.places.front();
        for (double away = 0.1; away < kFarthestWords && away / 100 < fewest; away += kStep)
            for (std::size_t choice = 0; choice < tag.places.size(); ++choice)
                for (int i = 0; i < kDirections; ++i) {
                    const Point at = tag.places[choice];
                    // Upwards first.
                    const double angle = 2 * std::numbers::pi * i / kDirections, right = std::sin(angle), down = -std::cos(angle);
                    const double reach_x = clear_.mark + clear_.across + away + tag.block.width / 2;
                    const double reach_y = clear_.mark + clear_.down + away + tag.block.height / 2;
                    // On the outline of a box around the mark rather than on a circle: words are wide.
                    const double most = std::max(std::abs(right), std::abs(down));
                    const Point corner = ground_.cells.nearest({at.x + right / most * reach_x - tag.block.width / 2,
                                                                at.y + down / most * reach_y - tag.block.height / 2},
                                                               tag.block);
                    const Rect box{corner.x, corner.y, tag.block.width, tag.block.height};
                    const double far = away / 100 + static_cast<double>(choice) / 1000;
                    const double faults = far < fewest ? faults_of(tag, at, box, tags, fewest - far) + far : INFINITY;
                    if (faults >= fewest) continue;
                    fewest = faults;
                    best = box;
                    best_at = at;
                }
        tag.at = best_at;
        tag.place = best;
        tag.placed = true;
    }

    // What would be wrong with these words there: each fault counts more than any distance.
    // From `enough` on it does not matter how much.
    double faults_of(const ChartTag& tag, Point at, const Rect& place, const std::vector<ChartTag>& tags, double enough) const {
        constexpr double kTouches = 3;  // words can no longer be read; a line that crosses another still leads
        const Rect& field = ground_.field;
        double faults = 0;
        if (place.left < field.left + kChartTick + clear_.across || place.top < ground_.top + kChartLines ||
            place.left + place.width > ground_.drawing.width ||
            place.top + place.height > field.top + field.height - kChartTick - clear_.down)
            faults += 5;
        if (faults >= enough) return faults;
        const Rect kept = grown(place, clear_.across, clear_.down);
        const std::vector<Point> lead = lead_between(at, place, clear_, begins_at(tag, clear_));
        for (const Point& mark : ground_.marks) {
            const double radius = clear_.mark;
            if (room_between(kept, {mark, mark}, radius) < radius) faults += kTouches;
            // Without a line a finger takes the nearest mark.
            if (lead.empty() && distance(mark, at) > 0 &&
                room_between(place, {mark, mark}, kFarthestWords) < room_between(place, {at, at}, kFarthestWords) + kNearer)
                faults += 0.5;
            const double clear = std::min(radius + kChartClear, distance(mark, at));
            if (!lead.empty() && clear > 0 && room_between({mark.x, mark.y, 0, 0}, lead, clear) < clear) faults += 0.7;
        }
        for (const Rect& box : ground_.words)
            if (gap_between(place.left, place.width, box.left, box.width) < clear_.words &&
                gap_between(place.top, place.height, box.top, box.height) < kChartLines - kLetterRounding)
                faults += kTouches;
        for (const ChartTag& other : tags) {
            if (&other == &tag || !other.placed) continue;
            const Rect& box = other.place;
            if (gap_between(place.left, place.width, box.left, box.width) < clear_.words &&
                gap_between(place.top, place.height, box.top, box.height) < kChartLines - kLetterRounding)
                faults += kTouches;
            if (!lead.empty() && room_between(grown(box, clear_.across, clear_.down), lead, 0) <= 0) faults += kTouches;
            if (const auto theirs = lead_of(other, clear_); !theirs.empty() && room_between(kept, theirs, 0) <= 0)
                faults += kTouches;
        }
        if (faults >= enough) return faults;
        return faults + faults_by_curves(tag, place, kept, lead, kTouches) + (lead.empty() ? 0 : 0.2);
    }

    double faults_by_curves(const ChartTag& tag, const Rect& place, const Rect& kept, const std::vector<Point>& lead,
                            double touches) const {
        double faults = 0, own = INFINITY, others = INFINITY;
        for (std::size_t i = 0; i < ground_.drawing.strokes.size(); ++i) {
            const Stroke& stroke = ground_.drawing.strokes[i];
            if (stroke.role == Role::symbol || stroke.line == LineClass::thin) continue;
            const double wider = (width_of(stroke.line, ground_.medium) - ground_.medium.thin_line) / 2;  // than a thin line
            if (room_between(kept, stroke.points, wider) <= wider ||
                (stroke.closed && room_between(kept, {stroke.points.back(), stroke.points.front()}, wider) <= wider))
                faults += touches;
            if (!lead.empty() && comes_to(lead, stroke.points)) faults += 1;
            if (tag.curve.empty() || !lead.empty()) continue;
            const bool names_it = std::find(tag.curve.begin(), tag.curve.end(), i) != tag.curve.end();
            double& nearest = names_it ? own : others;
            nearest = std::min(nearest, room_between(place, stroke.points, kLead * 2));
        }
        // Without a line a finger takes the nearest curve.
        return faults + (others < own + kNearer ? 0.5 : 0);
    }

    const ChartGround& ground_;
    const Clearance& clear_;
};

}  // namespace

std::string letter_of(std::size_t index) {
    const std::string last(1, static_cast<char>('a' + index % 26));
    return index < 26 ? last : letter_of(index / 26 - 1) + last;
}

Clearance clearance_on(const Medium& medium) {
    const double line = medium.thin_line / 2;  // a line is as much wider on either side
    constexpr double kWords = 8;               // mm between words in a line: an empty cell; with less two words are read as one
    const double thick = kChartClear + medium.thick_line / 2;
    if (!has_fixed_dots(medium)) return {kChartClear + line, kChartClear + line, kWords, 2.5, thick, thick};
    // A disc is to be felt as one, and a ring as hollow. Where words are set at once only the lines' dots move.
    return {kChartClear + 3.0 + 2.6, kChartClear + 5.0, kWords + 6.0, 4.0, kChartClear + 2.6, kChartClear + 3.3};
}

void place_letters(std::vector<ChartTag>& tags, const ChartGround& ground) { Letters(ground).place_all(tags); }

std::vector<Point> lead_of(const ChartTag& tag, const Clearance& clear) {
    return lead_between(tag.at, tag.place, clear, begins_at(tag, clear));
}

}  // namespace tactics
