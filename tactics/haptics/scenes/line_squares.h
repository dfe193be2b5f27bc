// SPDX-License-Identifier: Apache-2.0
// Squares of a plane, with the segments of lines that can be the nearest to a place in each.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// A segment of a line, mm.
struct LineSegment {
    Point from, way;  ///< way: its unit direction
    double length = 0;
    std::uint32_t line = 0, index = 0;  ///< index: that of the point where it begins
};

/// The segments of all lines, in order. Repeated points give one segment only; a line of one point has none. Points must be
/// finite.
std::vector<LineSegment> segments_of(const std::vector<std::vector<Point>>& lines);

/// mm along the segment to its nearest place
inline double nearest_along(const LineSegment& segment, Point place) noexcept {
    const double along = (place.x - segment.from.x) * segment.way.x + (place.y - segment.from.y) * segment.way.y;
    return std::clamp(along, 0.0, segment.length);
}
inline Point place_on(const LineSegment& segment, double along) noexcept {
    return {segment.from.x + along * segment.way.x, segment.from.y + along * segment.way.y};
}

/// Adjacent squares, from a corner on.
struct LineSquares {
    Point corner;     ///< the smallest x and y
    double side = 1;  ///< mm
    std::size_t columns = 0, rows = 0;
    Point middle(double column, double row, double squares = 1) const noexcept {
        return {corner.x + (column + squares / 2) * side, corner.y + (row + squares / 2) * side};
    }
};

/// Covers the lines and `far` mm around them with squares of that side, or larger ones if there would be more than `most`.
LineSquares squares_round(const std::vector<LineSegment>& segments, double far, double side, std::size_t most);

/// Calls square(column, row, across, segment) for each segment and each square whose middle is less than `within` mm from it, and
/// for some that are not; `across` is the distance from the middle to the line of the segment without ends. The squares must
/// reach farther round the segments than `within`.
template <typename Square>
void each_square_beside(const std::vector<LineSegment>& segments, const LineSquares& squares, double within, Square square) {
    struct Span {
        std::size_t first, end;
    };
    // Of the squares with a middle between two places, in sides from the corner on.
    const auto middles = [](double low, double high) {
        return Span{static_cast<std::size_t>(std::max(low + 0.5, 0.0)), static_cast<std::size_t>(std::max(high + 0.5, 0.0))};
    };
    const double around = within / squares.side * (1 + 1e-9);  // whatever is lost where numbers are rounded
    for (const LineSegment& segment : segments) {
        const auto sides = [&](double along) {
            const Point at = place_on(segment, along);
            return Point{(at.x - squares.corner.x) / squares.side, (at.y - squares.corner.y) / squares.side};
        };
        const Point from = sides(0), to = sides(segment.length);
        const double low = std::min(from.x, to.x) - around, high = std::max(from.x, to.x) + around;
        const double steep = std::abs(segment.way.y), slope = steep > 0 ? segment.way.x / segment.way.y : 0;
        // Where it crosses a row, and how far beside that a middle can be; a level line crosses none.
        const double half = steep > 0 ? around / steep : high - low;
        const Span rows = middles(std::min(from.y, to.y) - around, std::max(from.y, to.y) + around);
        for (std::size_t row = rows.first; row < std::min(rows.end, squares.rows); ++row) {
            const double crossed = from.x + (static_cast<double>(row) + 0.5 - from.y) * slope;
            const Span columns = middles(std::max(low, crossed - half), std::min(high, crossed + half));
            for (std::size_t column = columns.first; column < std::min(columns.end, squares.columns); ++column) {
                const double off = steep > 0 ? std::abs(static_cast<double>(column) + 0.5 - crossed) * steep : 0;
                square(column, row, off * squares.side, segment);
            }
        }
    }
}

struct FoundSegment {
    std::uint32_t segment;
    double distance;  ///< distance from the middle of the square, mm
};

/// run() calls square(column, row, nearest, found) for each square within `far` mm of a line, with the distance from its middle
/// to the nearest place of all lines and, with `whole`, all segments that can be the nearest to some place in it, else none.
/// Where `wanted(column, row, size)` says that none of size x size squares from there on is wanted, none is called for.
/// Starting with the whole plane, each square passes to its four quarters only segments that can be the nearest there, so the
/// time grows with the squares, and hardly with the segments.
template <typename Square, typename Wanted>
class SquareDescent {
public:
    SquareDescent(const std::vector<LineSegment>& segments, const LineSquares& squares, double far, bool whole, Square square,
                  Wanted wanted)
        : segments_(segments), squares_(squares), far_(far), around_(whole ? 1 : 0), square_(square), wanted_(wanted) {}

    void run() {
        std::size_t size = 2, depth = 2;
        for (; size < std::max(squares_.columns, squares_.rows); size *= 2) ++depth;
        levels_.resize(depth);
        std::vector<FoundSegment>& all = levels_[depth - 1].found;
        for (std::uint32_t i = 0; i < segments_.size(); ++i) all.push_back({i, 0});
        descend(0, 0, size, depth - 1);
    }

private:
    // Numbers for two places side by side.
    using Two = double __attribute__((vector_size(16)));
    struct Level {
        std::vector<FoundSegment> found;
        struct Squared {
            Two upper, lower;
            double of(std::size_t quarter) const noexcept { return (quarter < 2 ? upper : lower)[quarter % 2]; }
        };
        std::vector<Squared> squared;  // from the middles of the four quarters
    };

    // Most of the time goes here, so the four quarters of a square are measured at once.
    void descend(std::size_t column, std::size_t row, std::size_t size, std::size_t depth) {
        const std::size_t quarter = size / 2;
        const auto across = static_cast<double>(quarter);
        const auto middle = [&](std::size_t right, std::size_t down) {
            return squares_.middle(static_cast<double>(column + right), static_cast<double>(row + down), across);
        };
        Level& level = levels_[depth];
        const auto least = measure(level, middle(0, 0), middle(quarter, quarter));
        const double half = (across - 1 + around_) * squares_.side * std::sqrt(0.5);  // to the farthest that counts
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t there = column + k % 2 * quarter, down = row + k / 2 * quarter;
            if (there >= squares_.columns || down >= squares_.rows) continue;
            const double nearest = std::sqrt(least.of(k)), most = (nearest + 2 * half) * (nearest + 2 * half) * (1 + 1e-12);
            if (!(nearest - half < far_) || !wanted_(there, down, quarter)) continue;
            std::vector<FoundSegment>& found = levels_[depth - 1].found;
            if (quarter > 1 || around_ > 0) {
                take_near(level, k, most, found);
                if (found.size() > kFew && nearest > half)
                    leave_out_behind(middle(k % 2 * quarter, k / 2 * quarter), half * std::sqrt(0.5), found);
            }
            if (quarter > 1) {
                descend(there, down, quarter, depth - 1);
            } else {
                for (FoundSegment& one : found) one.distance = std::sqrt(one.distance);
                square_(there, down, nearest, found);
            }
        }
    }

    // From the segment to two places on a level.
    static Two squared_from(const LineSegment& segment, Two x, double y) noexcept {
        Two along = (x - segment.from.x) * segment.way.x + (y - segment.from.y) * segment.way.y;
        const Two none{}, end = none + segment.length;
        along = along < none ? none : along;
        along = end < along ? end : along;
        const Two right = x - (segment.from.x + along * segment.way.x), down = y - (segment.from.y + along * segment.way.y);
        return right * right + down * down;
    }

    // The least for each of the four quarters, squared as all are until they are chosen.
    typename Level::Squared measure(Level& level, Point upper_left, Point lower_right) const {
        const Two x = {upper_left.x, lower_right.x};
        constexpr double kNone = std::numeric_limits<double>::infinity();
        typename Level::Squared least{{kNone, kNone}, {kNone, kNone}};
        level.squared.resize(level.found.size());
        for (std::size_t i = 0; i < level.found.size(); ++i) {
            const LineSegment& segment = segments_[level.found[i].segment];
            const Two upper = squared_from(segment, x, upper_left.y), lower = squared_from(segment, x, lower_right.y);
            level.squared[i] = {upper, lower};
            least.upper = upper < least.upper ? upper : least.upper;
            least.lower = lower < least.lower ? lower : least.lower;
        }
        return least;
    }

    static void take_near(const Level& level, std::size_t quarter, double most, std::vector<FoundSegment>& found) {
        found.resize(level.found.size());
        std::size_t count = 0;
        for (std::size_t i = 0; i < level.found.size(); ++i) {
            const double squared = level.squared[i].of(quarter);
            found[count] = {level.found[i].segment, squared};
            count += squared > most ? 0 : 1;
        }
        found.resize(count);
    }

    // The place q that is nearest to the middle is in front of a segment everywhere in the square if it is so at the corners: the
    // squared distance to a segment less that to q is the least of linear functions, one for each place of the segment, and so
    // the least over a square is at a corner. Above the rugged edge of dense noise, few tips are left of hundreds.
    void leave_out_behind(Point middle, double half, std::vector<FoundSegment>& found) const {
        const FoundSegment& first = *std::min_element(
            found.begin(), found.end(), [](const FoundSegment& a, const FoundSegment& b) { return a.distance < b.distance; });
        const LineSegment& front = segments_[first.segment];
        const Point q = place_on(front, nearest_along(front, middle));
        const Two x = {middle.x - half, middle.x + half};
        const double up = middle.y - half, down = middle.y + half;
        const auto most = [&](double y) { return ((x - q.x) * (x - q.x) + (y - q.y) * (y - q.y)) * (1 + 1e-12); };
        const Two most_up = most(up), most_down = most(down);
        std::size_t count = 0;
        for (const FoundSegment& one : found) {
            const LineSegment& segment = segments_[one.segment];
            const auto near = (squared_from(segment, x, up) <= most_up) | (squared_from(segment, x, down) <= most_down);
            found[count] = one;
            count += (near[0] | near[1]) != 0 ? 1 : 0;
        }
        found.resize(count);
    }

    static constexpr std::size_t kFew = 8;  // as many cost less than to leave some out
    const std::vector<LineSegment>& segments_;
    const LineSquares& squares_;
    double far_;
    double around_;  // squares, round each middle
    Square square_;
    Wanted wanted_;
    std::vector<Level> levels_;  // at each depth, the smallest squares first
};

}  // namespace tactics
