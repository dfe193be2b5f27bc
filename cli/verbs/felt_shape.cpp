// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/felt_shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace tactics {

namespace {

constexpr double kBegin = 0.1, kEnd = 0.9;     // of a section
constexpr double kMissing = 0.13;              // of a section without a height: unknown
constexpr double kOfAll = 0.1, kOfOwn = 0.15;  // of the heights: less is level
constexpr double kAbrupt = 0.25;               // of a section, within which a soft step rises

// Up and down from one turn to the next, where it comes back by at least `least`: the section's own ends and its turns.
std::vector<double> turns_of(const std::vector<Point>& heights, double least) {
    std::vector<double> turns = {heights.front().y};
    double low = turns[0], high = turns[0];
    int way = 0;
    for (const Point& one : heights) {
        if (way == 0) {
            low = std::min(low, one.y), high = std::max(high, one.y);
            if (one.y - low >= least)
                way = 1, turns = {low}, high = one.y;
            else if (high - one.y >= least)
                way = -1, turns = {high}, low = one.y;
        } else if (way > 0) {
            high = std::max(high, one.y);
            if (high - one.y >= least) turns.push_back(high), low = one.y, way = -1;
        } else {
            low = std::min(low, one.y);
            if (one.y - low >= least) turns.push_back(low), high = one.y, way = 1;
        }
    }
    if (way != 0) turns.push_back(way > 0 ? high : low);
    return turns;
}

// One way all along, from the first height to the last: shares of the whole rise or fall, and where it happens.
class Rise {
public:
    Rise(const std::vector<Point>& heights, double from, double to) {
        for (const Point& one : heights) shares_.push_back({one.x, (one.y - from) / (to - from)});
    }
    // All but a tenth at either end lies within a short stretch, with as much level ground before and behind. Half of a hill, cut
    // off at its top, has that on one side only, and what becomes ever steeper has it before, but not behind.
    bool is_abrupt() const {
        const auto low = std::find_if(shares_.rbegin(), shares_.rend(), [](const Point& one) { return one.y < 0.1; });
        const auto high = std::find_if(shares_.begin(), shares_.end(), [](const Point& one) { return one.y > 0.9; });
        if (low == shares_.rend() || high == shares_.end()) return false;
        const double extent = high->x - low->x;
        return extent < kAbrupt && low->x - shares_.front().x >= extent && shares_.back().x - high->x >= extent;
    }
    // Its edges: short stretches that rise far more than what is beside them, and more than a quarter of the whole.
    struct Edges {
        int count = 0;
        double all = 0;  // share of the rise
    };
    Edges edges() const {
        Edges edges;
        std::vector<double> at;
        for (;;) {
            double best = kOfEdge, where = -1;
            for (const Point& one : shares_) {
                const auto is_taken = [&](double other) { return std::abs(other - one.x) < 2 * kEdge; };
                if (std::any_of(at.begin(), at.end(), is_taken)) continue;
                if (const double rise = over(one.x, one.x + kEdge); rise > best) best = rise, where = one.x;
            }
            if (where < 0) return edges;
            at.push_back(where);
            if (!stands_out(where, best)) continue;
            ++edges.count;
            edges.all += best;
        }
    }

private:
    static constexpr double kEdge = 0.1, kOfEdge = 0.28, kStandsOut = 6, kSides = 0.04;

    double at(double place) const {
        const auto next =
            std::lower_bound(shares_.begin(), shares_.end(), place, [](const Point& one, double x) { return one.x < x; });
        if (next == shares_.begin()) return next->y;
        if (next == shares_.end()) return shares_.back().y;
        const Point& before = *(next - 1);
        return before.y + (next->y - before.y) * (place - before.x) / (next->x - before.x);
    }
    double over(double from, double to) const { return at(to) - at(from); }
    bool stands_out(double from, double rise) const {
        const double to = from + kEdge;
        return from - shares_.front().x >= kSides && shares_.back().x - to >= kSides &&
               kStandsOut * std::abs(over(from - kEdge, from)) <= rise && kStandsOut * std::abs(over(to, to + kEdge)) <= rise;
    }

    std::vector<Point> shares_;
};

std::string_view one_way(const std::vector<Point>& heights, double from, double to) {
    constexpr double kMostly = 0.6;  // of the whole
    const Rise rise(heights, from, to);
    const Rise::Edges edges = rise.edges();
    if (edges.count > 1 && edges.all > kMostly) return "steps";
    return rise.is_abrupt() || edges.all > kMostly ? "step" : "slope";
}

struct ShapeWords {
    std::string_view name;
    SourceWords words;
};
constexpr ShapeWords kShapes[] = {{"level", SourceWords("level ground")},
                                  {"slope", SourceWords("a slope")},
                                  {"step", SourceWords("a step")},
                                  {"steps", SourceWords("a flight of steps")},
                                  {"waves", SourceWords("waves")},
                                  {"hump", SourceWords("a hump")},
                                  {"dip", SourceWords("a dip")},
                                  {"hill", SourceWords("a hill")},
                                  {"bowl", SourceWords("a bowl")},
                                  {"saddle", SourceWords("a saddle")},
                                  {"ridge", SourceWords("a ridge")},
                                  {"valley", SourceWords("a valley")},
                                  {"hole", SourceWords("a surface with a hole")}};

}  // namespace

std::string_view course_of(const Section& section, double whole) {
    const auto within = [](double share) { return share >= kBegin && share <= kEnd; };
    if (std::any_of(section.bare.begin(), section.bare.end(), within)) return "hole";
    std::vector<Point> heights;
    for (const Point& one : section.heights)
        if (within(one.x)) heights.push_back(one);
    double reached = kBegin;
    bool missing = false;
    for (const Point& one : heights) missing |= one.x - std::exchange(reached, one.x) > kMissing;
    if (missing || kEnd - reached > kMissing || !(whole > 0)) return "";
    const auto [low, high] =
        std::minmax_element(heights.begin(), heights.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
    const std::vector<double> turns = turns_of(heights, std::max(kOfAll * whole, kOfOwn * (high->y - low->y)));
    if (turns.size() < 2) return "level";
    if (turns.size() == 2) return one_way(heights, turns[0], turns[1]);
    if (turns.size() == 3) return turns[1] > turns[0] ? "hump" : "dip";
    return "waves";
}

std::string_view shape_of(std::string_view across, std::string_view down) {
    if (across.empty() || down.empty()) return "";
    const auto either = [&](std::string_view course) { return across == course || down == course; };
    if (either("hole")) return "hole";
    const bool humps = either("hump"), dips = either("dip"), step = either("step"), steps = either("steps"),
               waves = either("waves");
    if (humps && dips) return "saddle";
    if (humps + dips + step + steps + waves > 1) return "";
    if (waves) return "waves";
    if (steps) return "steps";
    if (step) return "step";
    if (humps) return across == down ? "hill" : "ridge";
    if (dips) return across == down ? "bowl" : "valley";
    return either("slope") ? "slope" : "level";
}

Phrase spoken_shape(std::string_view shape_or_course) {
    const auto found =
        std::find_if(std::begin(kShapes), std::end(kShapes), [&](const ShapeWords& one) { return one.name == shape_or_course; });
    return found == std::end(kShapes) ? Phrase(shape_or_course) : phrase(found->words);
}

}  // namespace tactics
