// SPDX-License-Identifier: Apache-2.0
// The point on the lines of a plot that is nearest to a finger, for speech, tones and guidance. Forces use line_field.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/haptics/scenes/line_squares.h"
#include "tactics/point3.h"

namespace tactics {

/// The result for a position beside lines.
struct Nearness {
    double distance = 0;      ///< mm
    std::uint32_t line = 0;   ///< the nearest one
    std::uint32_t index = 0;  ///< index of its point before the nearest place
    Point place;              ///< the nearest place itself
    bool within = false;      ///< false: no line is within reach, and the members above are invalid
};

/// Polylines in the plane z = 0. For every square of a grid, the segments that can be the nearest there are found in advance,
/// sorted by distance from its middle. Queries allocate nothing.
class NearLines {
public:
    /// Beyond `far` mm there is no result. Lines of one point have no segments; points must be finite.
    explicit NearLines(const std::vector<std::vector<Point>>& lines, double far = 10);

    Nearness at(const Point3& place) const noexcept;

private:
    struct Entry {
        std::uint32_t segment;
        float distance;  // mm from the middle of the square, at least; ascending
    };

    std::vector<LineSegment> segments_;
    double far_;
    LineSquares squares_;
    struct Span {
        std::size_t first = 0, end = 0;
    };
    std::vector<Span> spans_;  // for each square
    std::vector<Entry> entries_;
};

}  // namespace tactics
