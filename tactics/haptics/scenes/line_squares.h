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
        std::size_t size = 1, depth = 2;
        for (; size < std::max(squares_.columns, squares_.rows); size *= 2) ++depth;
        found_.resize(depth);
        for (std::uint32_t i = 0; i < segments_.size(); ++i) found_[depth - 1].push_back({i, 0});
        descend(0, 0, size, depth - 2);
    }

private:
    void descend(std::size_t column, std::size_t row, std::size_t size, std::size_t depth) {
        if (column >= squares_.columns || row >= squares_.rows) return;
        const auto across = static_cast<double>(size);
        const Point middle = squares_.middle(static_cast<double>(column), static_cast<double>(row), across);
        const double half = (across - 1 + around_) * squares_.side * std::sqrt(0.5);  // to the farthest that counts
        const std::vector<FoundSegment>& given = found_[depth + 1];
        std::vector<FoundSegment>& found = found_[depth];
        const bool middle_only = size == 1 && around_ == 0;
        found.resize(middle_only ? 0 : given.size());
        double least = std::numeric_limits<double>::infinity();  // squared, as all are until they are chosen
        for (std::size_t i = 0; i < given.size(); ++i) {
            const LineSegment& segment = segments_[given[i].segment];
            const Point place = place_on(segment, nearest_along(segment, middle));
            const double x = middle.x - place.x, y = middle.y - place.y, squared = x * x + y * y;
            if (!middle_only) found[i] = {given[i].segment, squared};
            least = std::min(least, squared);
        }
        const double nearest = std::sqrt(least), most = (nearest + 2 * half) * (nearest + 2 * half) * (1 + 1e-12);
        if (!(nearest - half < far_)) return;
        std::erase_if(found, [&](const FoundSegment& one) { return one.distance > most; });
        if (size == 1) {
            for (FoundSegment& one : found) one.distance = std::sqrt(one.distance);
            return square_(column, row, nearest, found);
        }
        const std::size_t quarter = size / 2;
        for (const std::size_t down : {std::size_t{0}, quarter})
            for (const std::size_t right : {std::size_t{0}, quarter}) descend(column + right, row + down, quarter, depth - 1);
    }

    const std::vector<LineSegment>& segments_;
    const LineSquares& squares_;
    double far_;
    double around_;  // squares, round each middle
    Square square_;
    std::vector<std::vector<FoundSegment>> found_;  // at each depth, the smallest squares first
};

}  // namespace tactics
