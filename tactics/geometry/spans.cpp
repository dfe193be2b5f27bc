// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/spans.h"

#include <algorithm>
#include <cmath>

namespace tactics {

bool span_within(Point a, Point b, double reach, double y, Span& span) {
    double left = 1e300, right = -1e300;
    const auto add = [&](double from, double to) {
        left = std::min(left, from);
        right = std::max(right, to);
    };
    for (const Point& end : {a, b}) {
        const double square = reach * reach - (y - end.y) * (y - end.y);
        if (square >= 0) add(end.x - std::sqrt(square), end.x + std::sqrt(square));
    }
    const double length = distance(a, b);
    if (length > 0) {
        // The two long sides, parallel to the middle line.
        const double nx = -(b.y - a.y) / length * reach, ny = (b.x - a.x) / length * reach;
        for (const double side : {-1.0, 1.0}) {
            const double ay = a.y + side * ny, by = b.y + side * ny;
            if ((ay > y) == (by > y)) continue;
            const double x = a.x + side * nx + (y - ay) / (by - ay) * (b.x - a.x);
            add(x, x);
        }
    }
    span = {left, right};
    return left <= right;
}

std::vector<Span> without(const std::vector<Span>& spans, const std::vector<Span>& taken) {
    std::vector<Span> left;
    std::size_t next = 0;
    double reached = -1e300;  // all up to here is taken
    for (const Span& span : spans) {
        double from = std::max(span.first, reached);
        while (next < taken.size() && taken[next].first < span.second) {
            if (taken[next].first > from) left.push_back({from, taken[next].first});
            reached = std::max(reached, taken[next].second);
            from = std::max(from, reached);
            ++next;
        }
        if (from < span.second) left.push_back({from, span.second});
    }
    return left;
}

}  // namespace tactics
