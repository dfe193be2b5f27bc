// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/felt_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

namespace tactics {

namespace {

constexpr double kBegin = 0.1, kEnd = 0.9;     // of a section
constexpr double kMissing = 0.13;              // of a section without a height: unknown
constexpr double kOfAll = 0.1, kOfOwn = 0.15;  // of the heights: less is level
constexpr double kAbrupt = 0.3;                // of a section, within which a soft step rises
constexpr double kLevelBeside = 0.7;           // of that, before and behind it

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

// Most of the ways up and down are large beside the whole range: no roughness on something larger.
bool are_waves(const std::vector<double>& turns, double range) {
    constexpr double kOfRange = 0.5;
    const auto large = [&](double one, double next) { return std::abs(next - one) >= kOfRange * range; };
    const auto count = std::inner_product(turns.begin() + 1, turns.end(), turns.begin(), std::size_t{0}, std::plus<>(), large);
    return turns.size() > 3 && 2 * count >= turns.size() - 1;
}

// Without roughness: of each height and those beside it the middle one, which leaves edges where they are. A needle would be
// gone, too: where some height stands out by at least `least` and far more than most do, all are as they were.
std::vector<Point> smoothed(const std::vector<Point>& heights, double least) {
    constexpr double kBeside = 0.04, kStandsOut = 8;  // of a section; times the roughness of most
    std::vector<Point> smooth;
    std::vector<double> near, off;
    const auto middle_of = [](std::vector<double>& values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    std::size_t first = 0, end = 0;
    for (const Point& one : heights) {
        // As far to one side as to the other, so that a slope stays as it is.
        const double beside = std::min({kBeside, one.x - heights.front().x, heights.back().x - one.x});
        while (first < heights.size() && heights[first].x < one.x - kBeside) ++first;
        while (end < heights.size() && heights[end].x <= one.x + kBeside) ++end;
        near.clear();
        for (std::size_t i = first; i < end; ++i)
            if (std::abs(heights[i].x - one.x) <= beside) near.push_back(heights[i].y);
        smooth.push_back({one.x, middle_of(near)});
        off.push_back(std::abs(one.y - smooth.back().y));
    }
    const double most = off.empty() ? 0 : *std::max_element(off.begin(), off.end());
    return most >= least && most > kStandsOut * middle_of(off) ? heights : smooth;
}

// One way all along, from the first height to the last: shares of the whole rise or fall, and where it happens.
class Rise {
public:
    Rise(const std::vector<Point>& heights, double from, double to) {
        for (const Point& one : heights) shares_.push_back({one.x, (one.y - from) / (to - from)});
    }
    // All but a tenth at either end lies within a short stretch, with level ground before and behind. Half of a hill, cut off at
    // its top, has that on one side only, and what becomes ever steeper has it before, but not behind.
    bool is_abrupt() const {
        const auto low = std::find_if(shares_.rbegin(), shares_.rend(), [](const Point& one) { return one.y < 0.1; });
        const auto high = std::find_if(shares_.begin(), shares_.end(), [](const Point& one) { return one.y > 0.9; });
        if (low == shares_.rend() || high == shares_.end()) return false;
        const double extent = high->x - low->x;
        const double level = kLevelBeside * extent;
        return extent < kAbrupt && low->x - shares_.front().x >= level && shares_.back().x - high->x >= level;
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

    // Means of equal pieces.
    std::array<double, 64> pieces() const {
        constexpr int kPlaces = 8;  // in each
        std::array<double, 64> means{};
        const double wide = (shares_.back().x - shares_.front().x) / static_cast<double>(means.size());
        for (std::size_t i = 0; i < means.size(); ++i)
            for (int k = 0; k < kPlaces; ++k)
                means[i] += at(shares_.front().x + (static_cast<double>(i) + (k + 0.5) / kPlaces) * wide) / kPlaces;
        return means;
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

// Levels one above the other, however rough and however unequally high: the stretches whose means leave the least squares. They
// are levels if none of them itself rises by a quarter of what is between it and the next, and if that is no roughness.
class Levels {
public:
    // Of the rise in equal pieces, means of each.
    explicit Levels(std::array<double, 64> pieces) {
        for (std::size_t i = 0; i < kPieces; ++i) {
            const auto x = static_cast<double>(i);
            const Sums here{1, x, pieces[i], x * x, x * pieces[i], pieces[i] * pieces[i]};
            sums_[i + 1] = sums_[i];
            sums_[i + 1].add(here, 1);
        }
    }
    // How many, up to five; 0: none.
    std::size_t count() const {
        for (std::size_t count = kMostLevels; count > 1; --count)
            if (are_levels(parted(count))) return count;
        return 0;
    }

private:
    static constexpr std::size_t kPieces = 64, kMostLevels = 5, kLeastPieces = 5;  // of a level: a sixteenth of the section
    static constexpr std::size_t kBetween = 4;                                     // pieces of the way from one to the next
    static constexpr double kRises = 0.25, kRough = 5, kLeastRise = 0.12;          // of what is between two; of the whole

    struct Sums {
        double count = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
        void add(const Sums& other, double sign) {
            count += sign * other.count, x += sign * other.x, y += sign * other.y;
            xx += sign * other.xx, xy += sign * other.xy, yy += sign * other.yy;
        }
        double squares() const { return std::max(0.0, yy - y * y / count); }
        double mean() const { return y / count; }
        // From its beginning to its end, of the straight line that fits best.
        double rise() const { return (xy - x * y / count) / (xx - x * x / count) * count; }
    };
    struct Stretch {
        std::size_t first = 0, end = 0;
    };

    Sums of(const Stretch& one) const {
        Sums sums = sums_[one.end];
        sums.add(sums_[one.first], -1);
        return sums;
    }
    // The best of all ways to part the whole into so many stretches, with few pieces left out between them.
    std::vector<Stretch> parted(std::size_t count) const {
        struct Best {
            double squares = INFINITY;
            std::size_t first = 0, before = 0;  // of the last stretch; where the one before it ends
        };
        std::vector<std::vector<Best>> best(count, std::vector<Best>(kPieces + 1));
        for (std::size_t end = kLeastPieces; end <= kPieces; ++end) best[0][end].squares = of({0, end}).squares();
        for (std::size_t k = 1; k < count; ++k)
            for (std::size_t before = kLeastPieces; before <= kPieces; ++before)
                for (std::size_t first = before; first <= before + kBetween; ++first)
                    for (std::size_t end = first + kLeastPieces; end <= kPieces; ++end)
                        if (const double squares = best[k - 1][before].squares + of({first, end}).squares();
                            squares < best[k][end].squares)
                            best[k][end] = {squares, first, before};
        std::vector<Stretch> stretches(count);
        std::size_t end = kPieces;
        for (std::size_t k = count; k-- > 0;) {
            stretches[k] = {best[k][end].first, end};
            end = best[k][end].before;
        }
        return stretches;
    }
    bool are_levels(const std::vector<Stretch>& stretches) const {
        double squares = 0, pieces = 0;
        for (const Stretch& one : stretches) squares += of(one).squares(), pieces += of(one).count;
        const double least = std::max(kLeastRise, kRough * std::sqrt(squares / pieces));
        for (std::size_t k = 0; k + 1 < stretches.size(); ++k) {
            const Sums below = of(stretches[k]), above = of(stretches[k + 1]);
            const double between = above.mean() - below.mean();
            if (!(between >= least) || std::max(std::abs(below.rise()), std::abs(above.rise())) > kRises * between) return false;
        }
        return true;
    }

    std::array<Sums, kPieces + 1> sums_;
};

std::string_view one_way(const std::vector<Point>& heights, double from, double to) {
    constexpr double kMostly = 0.6;  // of the whole
    const Rise rise(heights, from, to);
    if (const std::size_t levels = Levels(rise.pieces()).count(); levels > 0) return levels > 2 ? "steps" : "step";
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
    const double least = std::max(kOfAll * whole, kOfOwn * (high->y - low->y));
    std::vector<double> turns = turns_of(heights, least);
    if (!are_waves(turns, high->y - low->y)) turns = turns_of(smoothed(heights, least), least);
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
