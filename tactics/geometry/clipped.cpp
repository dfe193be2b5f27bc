// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/clipped.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace tactics {

namespace {

// The part of a line between two points that lies within (Y.-D. Liang and B. Barsky, 1984), as shares of it.
std::optional<std::pair<double, double>> part_within(const Rect& rect, Point a, Point b) {
    double from = 0, to = 1;
    const auto cut = [&](double step, double room) {
        if (step == 0) return room >= 0;
        const double at = room / step;
        if (step < 0)
            from = std::max(from, at);
        else
            to = std::min(to, at);
        return from <= to;
    };
    if (cut(a.x - b.x, a.x - rect.left) && cut(b.x - a.x, rect.left + rect.width - a.x) && cut(a.y - b.y, a.y - rect.top) &&
        cut(b.y - a.y, rect.top + rect.height - a.y))
        return std::pair{from, to};
    return std::nullopt;
}

Point between(Point a, Point b, double share) {
    if (share <= 0) return a;
    if (share >= 1) return b;
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

}  // namespace

std::vector<std::vector<Point>> clipped(const std::vector<Point>& points, bool closed, const Rect& rect) {
    std::vector<std::vector<Point>> parts;
    bool goes_on = false;  // the last part ends where the next side begins
    const std::size_t sides = points.empty() ? 0 : points.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < sides; ++i) {
        const Point a = points[i], b = points[(i + 1) % points.size()];
        const auto part = part_within(rect, a, b);
        if (!part) {
            goes_on = false;
            continue;
        }
        if (!goes_on) parts.push_back({between(a, b, part->first)});
        parts.back().push_back(between(a, b, part->second));
        goes_on = part->second >= 1;
    }
    return parts;
}

// One side after the other (I. Sutherland and G. Hodgman, 1974).
std::vector<Point> ring_within(std::vector<Point> ring, const Rect& rect) {
    const auto keep = [&](auto inside) {
        std::vector<Point> kept;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            const double at = inside(a), next = inside(b);
            if (at >= 0) kept.push_back(a);
            if ((at > 0 && next < 0) || (at < 0 && next > 0)) kept.push_back(between(a, b, at / (at - next)));
        }
        ring = std::move(kept);
    };
    keep([&](Point p) { return p.x - rect.left; });
    keep([&](Point p) { return rect.left + rect.width - p.x; });
    keep([&](Point p) { return p.y - rect.top; });
    keep([&](Point p) { return rect.top + rect.height - p.y; });
    return ring;
}

}  // namespace tactics
