// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/guided_lines.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

constexpr std::size_t kSamples = 1024;
constexpr int kMostPieces = 64;

struct Turn {
    std::size_t point;
    bool highest;
};

// Finds turns in a sequence of heights: a maximum is confirmed when the curve has fallen far enough from it.
class Turns {
public:
    explicit Turns(double least) : least_(least) {}
    // mm upwards. Calls take(turn) with the turn that this height makes known.
    template <typename Take>
    void add(std::size_t point, double height, Take take) {
        if (none_) {
            high_at_ = low_at_ = point;
            high_ = low_ = height;
            none_ = false;
            return;
        }
        if (height > high_) high_ = height, high_at_ = point;
        if (height < low_) low_ = height, low_at_ = point;
        if (course_ >= 0 && height <= high_ - least_) {
            if (course_ > 0) take(Turn{high_at_, true});
            course_ = -1;
            low_ = height, low_at_ = point;
        } else if (course_ <= 0 && height >= low_ + least_) {
            if (course_ < 0) take(Turn{low_at_, false});
            course_ = 1;
            high_ = height, high_at_ = point;
        }
    }
    void begin_again() noexcept { none_ = true, course_ = 0; }

private:
    double least_;
    bool none_ = true;
    int course_ = 0;  // up, down; 0 as long as it has not gone far either way from where it begins
    std::size_t high_at_ = 0, low_at_ = 0;
    double high_ = 0, low_ = 0;
};

struct FoundTurns {
    std::vector<Turn> turns;
    double side = 0;     // mm, the longer one of the curve
    bool dense = false;  // there are smaller ones that no finger tells
};
FoundTurns turns_of(const PlotCurve& curve, const PlotFrame& frame) {
    Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    std::vector<double> heights;
    heights.reserve(curve.points.size());
    for (const PlotPoint& point : curve.points) {
        const Point at{frame.across(point.x), frame.down(point.y)};
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
        heights.push_back(-at.y);
    }
    FoundTurns found{{}, std::max(high.x - low.x, high.y - low.y), false};
    const auto too_many = [&] { return static_cast<double>(found.turns.size()) * kLeastTurn > found.side; };
    // Above twice the side there are none. Of noise the first points tell that there are too many.
    for (double least = kLeastTurn;; least *= 2) {
        found.turns.clear();
        Turns turns(least);
        auto gap = curve.gaps.begin();
        for (std::size_t k = 0; k < heights.size() && !too_many(); ++k) {
            if (gap != curve.gaps.end() && *gap == k) {
                turns.begin_again();
                ++gap;
            }
            turns.add(k, heights[k], [&](const Turn& turn) { found.turns.push_back(turn); });
        }
        if (!too_many()) return found;
        found.dense = true;
    }
}

}  // namespace

GuidedLines::GuidedLines(const Plot& plot, const PlotFrame& frame, const FeltLines& felt, double resolution) {
    take_lines(felt, plot.curves.size());
    take_samples();
    winding_.assign(plot.curves.size(), 1);
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        turn_firsts_.push_back(turns_.size());
        if (has_place(i)) place_turns(plot.curves[i], i, frame, resolution);
    }
    turn_firsts_.push_back(turns_.size());
}

void GuidedLines::take_lines(const FeltLines& felt, std::size_t curves) {
    for (std::uint32_t line = 0; line < felt.lines.size(); ++line) {
        const auto curve = static_cast<std::uint32_t>(felt.curve[line]);
        while (firsts_.size() <= curve) firsts_.push_back(line);
        starts_.push_back(points_.size());
        curve_.push_back(curve);
        double along = 0;
        Reached reached{INFINITY, -INFINITY};
        const std::vector<Point>& points = felt.lines[line];
        for (std::size_t i = 0; i < points.size(); ++i) {
            Point sum;
            if (i > 0) {
                const double length = distance(points[i - 1], points[i]);
                along += length;
                sum = {sums_.back().x + length * (points[i - 1].x + points[i].x) / 2,
                       sums_.back().y + length * (points[i - 1].y + points[i].y) / 2};
            }
            sums_.push_back(sum);
            reached = {std::min(reached.low, points[i].x), std::max(reached.high, points[i].x)};
            points_.push_back(points[i]);
            along_.push_back(along);
            reached_.push_back(reached);
        }
        pieces_.push_back({reached.low, reached.high, line});
    }
    starts_.push_back(points_.size());
    while (firsts_.size() <= curves) firsts_.push_back(static_cast<std::uint32_t>(felt.lines.size()));
    for (std::size_t i = 0; i + 1 < firsts_.size(); ++i)
        std::sort(pieces_.begin() + firsts_[i], pieces_.begin() + firsts_[i + 1],
                  [](const Piece& a, const Piece& b) { return a.low != b.low ? a.low < b.low : a.line < b.line; });
}

void GuidedLines::take_samples() {
    double all = 0;
    for (std::uint32_t line = 0; line < curve_.size(); ++line) all += length(line);
    const double apart = all / kSamples;
    double next = 0;  // mm from the beginning of the line
    for (std::uint32_t line = 0; line < curve_.size() && apart > 0; ++line) {
        for (; next <= length(line) && samples_.size() < kSamples; next += apart)
            samples_.push_back({{line, next}, at({line, next})});
        next -= length(line);
    }
}

// Forwards from the segment `from`: the first that passes the point near enough, and from there on as long as it comes nearer.
std::optional<LinePlace> GuidedLines::place_on(std::uint32_t line, Point point, double within, std::size_t& from) const {
    std::optional<LinePlace> found;
    double nearest = within;
    for (std::size_t i = std::max(from, starts_[line]); i + 1 < starts_[line + 1]; ++i) {
        const Point a = points_[i], b = points_[i + 1];
        const double length = along_[i + 1] - along_[i];
        double along = 0;
        if (length > 0) along = std::clamp(((point.x - a.x) * (b.x - a.x) + (point.y - a.y) * (b.y - a.y)) / length, 0.0, length);
        const LinePlace place{line, along_[i] + along};
        const double away = distance(at(place), point);
        if (away > nearest && found) break;
        if (away > nearest) continue;
        nearest = away;
        found = place;
        from = i;
    }
    return found;
}

void GuidedLines::place_turns(const PlotCurve& curve, std::size_t index, const PlotFrame& frame, double resolution) {
    std::uint32_t line = firsts_[index];
    std::size_t from = starts_[line];
    const FoundTurns found = turns_of(curve, frame);
    if (found.dense) {
        double whole = 0;
        for (std::uint32_t one = line; one < firsts_[index + 1]; ++one) whole += length(one);
        winding_[index] = std::max(1.0, whole / found.side);
    }
    for (const Turn& turn : found.turns) {
        const PlotPoint& value = curve.points[turn.point];
        const Point place{frame.across(value.x), frame.down(value.y)};
        // A gap may have begun other lines since the last one.
        for (std::uint32_t next = line; next < firsts_[index + 1]; ++next) {
            std::size_t there = next == line ? from : starts_[next];
            const auto at = place_on(next, place, resolution, there);
            if (!at) continue;
            turns_.push_back({*at, value, turn.highest});
            line = next;
            from = there;
            break;
        }
    }
}

// The point behind it, of all.
std::size_t GuidedLines::after(const LinePlace& place) const noexcept {
    const auto begin = along_.begin() + static_cast<std::ptrdiff_t>(starts_[place.line]),
               end = along_.begin() + static_cast<std::ptrdiff_t>(starts_[place.line + 1]);
    return static_cast<std::size_t>(std::upper_bound(begin + 1, end - 1, place.along) - along_.begin());
}

Point GuidedLines::at(const LinePlace& place) const noexcept {
    const std::size_t next = after(place);
    const Point a = points_[next - 1], b = points_[next];
    const double length = along_[next] - along_[next - 1];
    const double share = length > 0 ? std::clamp((place.along - along_[next - 1]) / length, 0.0, 1.0) : 0;
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

Point GuidedLines::sum_to(std::uint32_t line, double along) const noexcept {
    const std::size_t before = after({line, along}) - 1;
    const Point from = points_[before], to = at({line, along}), sum = sums_[before];
    const double length = along - along_[before];
    return {sum.x + length * (from.x + to.x) / 2, sum.y + length * (from.y + to.y) / 2};
}

Point GuidedLines::middle_at(const LinePlace& place, const LinePlace& stop) const noexcept {
    constexpr double kLeast = 1e-6;  // mm: it is there
    const double winding = winding_[curve_[place.line]];
    double half = winding > 1 ? winding * kLeastTurn / 2 : 0;
    half = std::min({half, place.along, length(place.line) - place.along});
    if (place.line == stop.line) half = std::min(half, std::abs(place.along - stop.along));
    if (!(half > kLeast)) return at(place);
    const Point from = sum_to(place.line, place.along - half), to = sum_to(place.line, place.along + half);
    return {(to.x - from.x) / (2 * half), (to.y - from.y) / (2 * half)};
}

LinePlace GuidedLines::place_of(const Nearness& near) const noexcept {
    const std::size_t point = starts_[near.line] + near.index;
    return {near.line, std::min(along_[point] + distance(points_[point], near.place), length(near.line))};
}

LinePlace GuidedLines::roughly_nearest(Point finger) const noexcept {
    LinePlace nearest;
    double least = INFINITY;
    for (const Sample& sample : samples_)
        if (const double away = distance(sample.at, finger); away < least) {
            least = away;
            nearest = sample.place;
        }
    return nearest;
}

// The points up to any of a line have all x between their least and their largest, as the line does not break.
std::optional<LinePlace> GuidedLines::first_at(std::size_t curve, double x) const noexcept {
    const auto begin = pieces_.begin() + firsts_[curve], end = pieces_.begin() + firsts_[curve + 1];
    auto piece = std::upper_bound(begin, end, x, [](double value, const Piece& one) { return value < one.low; });
    std::optional<std::uint32_t> line;
    for (int tries = 0; piece != begin && tries < kMostPieces; ++tries) {
        --piece;
        if (piece->high >= x && (!line || piece->line < *line)) line = piece->line;
    }
    if (!line) return std::nullopt;
    const auto from = reached_.begin() + static_cast<std::ptrdiff_t>(starts_[*line]),
               to = reached_.begin() + static_cast<std::ptrdiff_t>(starts_[*line + 1]);
    const auto met = std::partition_point(from, to, [&](const Reached& one) { return !(one.low <= x && x <= one.high); });
    const auto point = static_cast<std::size_t>(met - reached_.begin());
    if (met == from) return LinePlace{*line, 0};
    const double across = points_[point].x - points_[point - 1].x;
    const double share = across != 0 ? std::clamp((x - points_[point - 1].x) / across, 0.0, 1.0) : 0;
    return LinePlace{*line, along_[point - 1] + share * (along_[point] - along_[point - 1])};
}

const CurveTurn* GuidedLines::next_turn(const LinePlace& from, bool forward) const noexcept {
    constexpr double kThere = 1e-6;  // mm: where it is
    const std::span<const CurveTurn> all = turns(curve_[from.line]);
    const auto before = [&](double by) {
        return [&, by](const CurveTurn& turn) {
            return turn.at.line != from.line ? turn.at.line < from.line : turn.at.along < from.along + by;
        };
    };
    if (forward) {
        const auto next = std::partition_point(all.begin(), all.end(), before(kThere));
        return next == all.end() ? nullptr : &*next;
    }
    const auto next = std::partition_point(all.begin(), all.end(), before(-kThere));
    return next == all.begin() ? nullptr : &*(next - 1);
}

}  // namespace tactics
