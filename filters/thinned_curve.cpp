// SPDX-License-Identifier: Apache-2.0
#include "filters/thinned_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactics {

std::vector<Point> thinned_curve(std::vector<Point> points, double width) {
    // What is kept is never behind what is read, so that the curve needs no second place.
    std::size_t kept = 0;
    for (std::size_t begin = 0; begin < points.size();) {
        const double column = std::floor(points[begin].x / width);
        std::size_t low = begin, high = begin, end = begin + 1;
        for (; end < points.size() && std::floor(points[end].x / width) == column; ++end) {
            if (points[end].y < points[low].y) low = end;
            if (points[end].y > points[high].y) high = end;
        }
        std::array<std::size_t, 4> stay = {begin, low, high, end - 1};
        std::sort(stay.begin(), stay.end());
        const auto last = std::unique(stay.begin(), stay.end());
        for (auto at = stay.begin(); at != last; ++at) points[kept++] = points[*at];
        begin = end;
    }
    points.resize(kept);
    return points;
}

}  // namespace tactics
