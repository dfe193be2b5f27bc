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

struct FoundSegment {
    std::uint32_t segment;
    double distance;  ///< distance from the middle of the square, mm
};

/// run() calls square(column, row, nearest, found) for each square within `far` mm of a line, with the distance from its middle
/// to the nearest place of all lines and, with `whole`, all segments that can be the nearest to some place in it, else none.
/// Starting with the whole plane, each square passes to its four quarters only segments that can be the nearest there, so the
/// time grows with the squares, and hardly with the segments.
template <typename Square>
class SquareDescent {
public:
    SquareDescent(const std::vector<LineSegment>& segments, const LineSquares& squares, double far, bool whole, Square square)
        : segments_(segments), squares_(squares), far_(far), around_(whole ? 1 : 0), square_(square) {}

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
            if (!(nearest - half < far_)) continue;
            std::vector<FoundSegment>& found = levels_[depth - 1].found;
            if (quarter > 1 || around_ > 0) take_near(level, k, most, found);
            if (quarter > 1) {
                descend(there, down, quarter, depth - 1);
            } else {
                for (FoundSegment& one : found) one.distance = std::sqrt(one.distance);
                square_(there, down, nearest, found);
            }
        }
    }

    // The least for each of the four quarters, squared as all are until they are chosen.
    typename Level::Squared measure(Level& level, Point upper_left, Point lower_right) const {
        const Two x = {upper_left.x, lower_right.x};
        constexpr double kNone = std::numeric_limits<double>::infinity();
        typename Level::Squared least{{kNone, kNone}, {kNone, kNone}};
        level.squared.resize(level.found.size());
        for (std::size_t i = 0; i < level.found.size(); ++i) {
            const LineSegment& segment = segments_[level.found[i].segment];
            const Two across = (x - segment.from.x) * segment.way.x;
            const auto squared = [&](double y) {
                Two along = across + (y - segment.from.y) * segment.way.y;
                const Two none{}, end = none + segment.length;
                along = along < none ? none : along;
                along = end < along ? end : along;
                const Two right = x - (segment.from.x + along * segment.way.x),
                          down = y - (segment.from.y + along * segment.way.y);
                return right * right + down * down;
            };
            const Two upper = squared(upper_left.y), lower = squared(lower_right.y);
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

    const std::vector<LineSegment>& segments_;
    const LineSquares& squares_;
    double far_;
    double around_;  // squares, round each middle
    Square square_;
    std::vector<Level> levels_;  // at each depth, the smallest squares first
};

}  // namespace tactics
