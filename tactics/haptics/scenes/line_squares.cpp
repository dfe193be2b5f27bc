// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/line_squares.h"

namespace tactics {

std::vector<LineSegment> segments_of(const std::vector<std::vector<Point>>& lines) {
    std::vector<LineSegment> segments;
    for (std::size_t line = 0; line < lines.size(); ++line)
        for (std::size_t i = 0; i + 1 < lines[line].size(); ++i) {
            const Point from = lines[line][i], to = lines[line][i + 1];
            const double length = distance(from, to);
            if (!(length > 0)) continue;
            segments.push_back({from,
                                {(to.x - from.x) / length, (to.y - from.y) / length},
                                length,
                                static_cast<std::uint32_t>(line),
                                static_cast<std::uint32_t>(i)});
        }
    return segments;
}

LineSquares squares_round(const std::vector<LineSegment>& segments, double far, double side, std::size_t most) {
    if (segments.empty()) return {};
    Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    for (const LineSegment& segment : segments)
        for (const Point p : {segment.from, place_on(segment, segment.length)}) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    const double width = high.x - low.x + 2 * far, height = high.y - low.y + 2 * far;
    // Beginning with n squares, up to n + 1 are needed.
    side = std::max(side, (width + height) / static_cast<double>(most / 4));
    side = std::max(side, std::sqrt(width * height / (0.99 * static_cast<double>(most))));
    const auto over = [&](double length) { return static_cast<std::size_t>(length / side) + 1; };
    return {{low.x - far, low.y - far}, side, over(width), over(height)};
}

}  // namespace tactics
