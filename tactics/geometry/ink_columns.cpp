// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/ink_columns.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace tactics {

namespace {

constexpr double kNoticed = 1, kFarther = 3;         // mm up and down again that a finger notices; times that: that it follows
constexpr double kGrain = 3.5;                       // pixels that JPEG leaves beside a line
constexpr double kFinger = 3.2;                      // mm from one turn to the next: the least clear gap (filters/separate.cpp)
constexpr double kFelt = 1;                          // mm, a line's width
constexpr double kFinest = 1.5, kCoarsest = 12;      // mm of a stretch, as in filters/chart_curves.cpp
constexpr double kMirrored = -0.6;                   // correlation of how the upper and the lower side go on
constexpr std::size_t kParts = 8, kNoisyParts = 6;   // of a curve's width
constexpr double kEvenStep = 0.2, kEvenSteps = 0.6;  // of the usual step from turn to turn; of all steps
constexpr double kSmallTurns = 1.5;                  // times those that a finger follows: waves have as many of both
constexpr double kFewPixels = 2;                     // shorter steps are even for lack of pixels
constexpr double kSpike = 8, kSpikeOfNoise = 4;      // mm; times what most places are off the curve

// Where it turns: what goes up and down by so much, at least.
std::vector<double> turns_of(const std::vector<Point>& line, double least) {
    std::vector<double> turns;
    int way = 0;
    Point low = line.front(), high = line.front();
    for (const Point& p : line) {
        if (way >= 0 && p.y > high.y) high = p;
        if (way <= 0 && p.y < low.y) low = p;
        if (way >= 0 && p.y < high.y - least) {
            if (way > 0) turns.push_back(high.x);
            way = -1;
            low = p;
        } else if (way <= 0 && p.y > low.y + least) {
            if (way < 0) turns.push_back(low.x);
            way = 1;
            high = p;
        }
    }
    return turns;
}

std::vector<Point> edge_of(const std::vector<InkColumn>& columns, bool top) {
    std::vector<Point> line;
    for (const InkColumn& column : columns)
        line.push_back({column.x + 0.5, static_cast<double>(top ? column.top : column.bottom)});
    return line;
}

// Error bars and markers go as far up as down; a curve goes either way.
bool is_mirrored(const std::vector<InkColumn>& columns) {
    double up = 0, down = 0, both = 0;
    for (std::size_t i = 1; i < columns.size(); ++i) {
        const double a = columns[i].top - columns[i - 1].top, b = columns[i].bottom - columns[i - 1].bottom;
        up += a * a, down += b * b, both += a * b;
    }
    return both < kMirrored * std::sqrt(up * down);
}

// The turns of the straighter side: a surface has one that hardly turns.
std::vector<double> fewest_turns(const std::vector<InkColumn>& columns, double least) {
    std::vector<double> one = turns_of(edge_of(columns, true), least), other = turns_of(edge_of(columns, false), least);
    return one.size() < other.size() ? one : other;
}

// A wave is none, however short: in place of its middle it is better drawn as it is.
bool is_even(const std::vector<double>& turns) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < turns.size(); ++i) steps.push_back(turns[i] - turns[i - 1]);
    if (steps.empty()) return false;
    const auto half = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), half, steps.end());
    const double usual = *half, off = std::max(0.5, kEvenStep * usual);
    const auto even = std::count_if(steps.begin(), steps.end(), [&](double step) { return std::abs(step - usual) <= off; });
    return usual > kFewPixels && static_cast<double>(even) > kEvenSteps * static_cast<double>(steps.size());
}

// A part of a curve that is drawn through its middle value.
struct Stretch {
    std::size_t begin = 0, end = 0;  // columns
    Point at;
};

class Followed {
public:
    Followed(const std::vector<InkColumn>& columns, double mm) : columns_(columns), mm_(mm) {
        const auto step = static_cast<std::size_t>(std::max(1.0, kFinest / mm));
        for (std::size_t i = 0; i < columns.size(); i += step)
            stretches_.push_back(stretch(i, std::min(i + step, columns.size())));
    }

    std::vector<Point> line() {
        for (bool again = true; again;) {
            again = false;
            for (std::size_t i = 1; i + 1 < stretches_.size(); ++i)
                if (is_too_sharp(i) && merge(i)) {
                    again = true;
                    i = i > 1 ? i - 2 : 0;
                }
        }
        std::vector<Point> line{point(columns_.front())};
        for (const Stretch& s : stretches_) line.push_back(s.at);
        line.push_back(point(columns_.back()));
        return line;
    }

private:
    static Point point(const InkColumn& column) { return {column.x + 0.5, column.middle()}; }

    Stretch stretch(std::size_t begin, std::size_t end) const {
        std::vector<double> values;
        for (std::size_t i = begin; i < end; ++i) values.push_back(columns_[i].middle());
        const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), half, values.end());
        return {begin, end, {(columns_[begin].x + columns_[end - 1].x + 1) / 2.0, *half}};
    }

    // Where the curve, on that side of a turn, has gone away from it by so much; nothing if it turns again before.
    std::optional<double> flank(std::size_t i, bool right, double height) const {
        const Point from = stretches_[i].at;
        const double way = stretches_[right ? i + 1 : i - 1].at.y < from.y ? -1 : 1;
        for (std::size_t k = i; right ? k + 1 < stretches_.size() : k > 0; right ? ++k : --k) {
            const Point a = stretches_[k].at, b = stretches_[right ? k + 1 : k - 1].at;
            const double before = (a.y - from.y) * way, after = (b.y - from.y) * way;
            if (after < before) return std::nullopt;
            if (after >= height) return a.x + (b.x - a.x) * (height - before) / std::max(after - before, 1e-9);
        }
        return std::nullopt;
    }

    // Two flanks nearer each other than a finger's gap, for longer than a bend is (rules/narrow.h).
    bool is_too_sharp(std::size_t i) const {
        const double before = stretches_[i].at.y - stretches_[i - 1].at.y, after = stretches_[i + 1].at.y - stretches_[i].at.y;
        if (before * after >= 0) return false;
        constexpr double kNarrow = 4;
        for (const double height : {2.0, 4.0, 8.0, 16.0}) {  // mm
            const auto left = flank(i, false, height / mm_), right = flank(i, true, height / mm_);
            if (!left || !right) return false;
            const double away = (*right - *left) * mm_, way = 2 * std::hypot(height, away / 2);
            if (away < kFinger + kFelt && way > kNarrow * away) return true;
        }
        return false;
    }

    // With the neighbour that is more like it, so that the other flank stays where it is.
    bool merge(std::size_t i) {
        const double left = std::abs(stretches_[i].at.y - stretches_[i - 1].at.y),
                     right = std::abs(stretches_[i].at.y - stretches_[i + 1].at.y);
        for (const std::size_t first : {left < right ? i - 1 : i, left < right ? i : i - 1}) {
            const Stretch joined = stretch(stretches_[first].begin, stretches_[first + 1].end);
            if (static_cast<double>(joined.end - joined.begin) * mm_ > kCoarsest) continue;
            stretches_[first] = joined;
            stretches_.erase(stretches_.begin() + static_cast<std::ptrdiff_t>(first) + 1);
            return true;
        }
        return false;
    }

    const std::vector<InkColumn>& columns_;
    double mm_;
    std::vector<Stretch> stretches_;
};

}  // namespace

bool is_noise(const std::vector<InkColumn>& columns, double mm) {
    const auto width = [mm](const std::vector<InkColumn>& of) { return (of.back().x - of.front().x) * mm; };
    const double noticed = std::max(kNoticed / mm, kGrain);
    const std::vector<double> turns = fewest_turns(columns, noticed);
    const auto all = static_cast<double>(turns.size()),
               far = static_cast<double>(fewest_turns(columns, kFarther * noticed).size());
    const bool often = all * kFinger > width(columns) || (all * 2 * kFinger > width(columns) && all > kSmallTurns * far);
    if (!often || is_even(turns) || is_mirrored(columns)) return false;
    std::size_t noisy = 0;
    for (std::size_t k = 0; k < kParts; ++k) {
        const std::vector<InkColumn> part(columns.begin() + static_cast<std::ptrdiff_t>(k * columns.size() / kParts),
                                          columns.begin() + static_cast<std::ptrdiff_t>((k + 1) * columns.size() / kParts));
        const auto own = static_cast<double>(fewest_turns(part, noticed).size() + 1);
        noisy += own * 2 * kFinger > width(part) ? 1 : 0;
    }
    return noisy >= kNoisyParts;
}

std::vector<Point> followable(const std::vector<InkColumn>& columns, double mm) { return Followed(columns, mm).line(); }

std::vector<double> heights_along(const std::vector<Point>& line, const std::vector<InkColumn>& columns) {
    std::vector<double> heights;
    std::size_t at = 1;
    for (const InkColumn& column : columns) {
        const double x = column.x + 0.5;
        while (at + 1 < line.size() && line[at].x < x) ++at;
        const Point a = line[at - 1], b = line[at];
        heights.push_back(a.y + (b.y - a.y) * (b.x > a.x ? std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0) : 0));
    }
    return heights;
}

std::vector<std::array<Point, 2>> spikes_of(const std::vector<InkColumn>& columns, const std::vector<Point>& line, double mm) {
    struct Off {
        Point foot, tip;
        double height = 0;
    };
    std::vector<Off> all;
    const std::vector<double> heights = heights_along(line, columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const InkColumn& column = columns[i];
        const double x = column.x + 0.5, y = heights[i];
        const double tip = y - column.top > column.bottom + 1 - y ? column.top : column.bottom + 1;
        all.push_back({{x, y}, {x, tip}, std::abs(tip - y)});
    }
    std::sort(all.begin(), all.end(), [](const Off& a, const Off& b) { return a.height > b.height; });
    const double least = std::max(kSpike / mm, kSpikeOfNoise * all[all.size() / 2].height);
    std::vector<std::array<Point, 2>> spikes;
    for (const Off& off : all) {
        if (off.height < least) break;
        if (std::none_of(spikes.begin(), spikes.end(),
                         [&](const auto& other) { return std::abs(other[0].x - off.foot.x) * mm < kFinger + kFelt; }))
            spikes.push_back({off.foot, off.tip});
    }
    return spikes;
}

}  // namespace tactics
