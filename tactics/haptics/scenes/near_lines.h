// SPDX-License-Identifier: Apache-2.0
// Which place of the lines of a plot is the nearest to a finger: for what is said, heard and led to. What is felt is
// line_field.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/haptics/scenes/line_squares.h"
#include "tactics/point3.h"

namespace tactics {

/// Of a place beside lines.
struct Nearness {
    double distance = 0;      ///< mm
    std::uint32_t line = 0;   ///< the nearest one
    std::uint32_t index = 0;  ///< of its point before the nearest place
    Point place;              ///< the nearest place itself
    bool within = false;      ///< false: no line is within reach, and nothing of the above is told
};

/// Polylines in the plane z = 0. For every square of a grid it is worked out beforehand which segments can be the nearest there,
/// the nearest to its middle first. Nothing allocates in a query.
class NearLines {
public:
    /// Beyond `far` mm nothing is told. Lines of one point have none; places must be finite.
    explicit NearLines(const std::vector<std::vector<Point>>& lines, double far = 10);

    Nearness at(const Point3& place) const noexcept;

private:
    struct Entry {
        std::uint32_t segment;
        float distance;  // mm from the middle of the square, rounded down
    };

    std::vector<LineSegment> segments_;
    double far_;
    LineSquares squares_;
    struct Span {
        std::size_t first = 0, end = 0;
    };
    std::vector<Span> spans_;  // of each square
    std::vector<Entry> entries_;
};

}  // namespace tactics
