// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/convex.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tactics/geometry/vectors.h"

namespace tactics {

namespace {

Point middle_of(const Convex& one) {
    Point sum{};
    for (const Point& at : one) sum = {sum.x + at.x, sum.y + at.y};
    const auto count = static_cast<double>(std::max<std::size_t>(one.size(), 1));
    return {sum.x / count, sum.y / count};
}

// Half of the points round, the last left out.
Convex chain(const std::vector<Point>& sorted) {
    Convex half;
    for (const Point& at : sorted) {
        while (half.size() >= 2 && cross(half.back() - half[half.size() - 2], at - half.back()) <= 0) half.pop_back();
        half.push_back(at);
    }
    if (half.size() > 1) half.pop_back();
    return half;
}

}  // namespace

Convex hull_of(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    points.erase(std::unique(points.begin(), points.end(), [](Point a, Point b) { return a.x == b.x && a.y == b.y; }),
                 points.end());
    if (points.size() < 2) return points;
    Convex hull = chain(points);
    std::reverse(points.begin(), points.end());
    const Convex back = chain(points);
    hull.insert(hull.end(), back.begin(), back.end());
    return hull;
}

double area_of(const Convex& one) {
    double sum = 0;
    for (std::size_t i = 0; i < one.size(); ++i) sum += cross(one[i], one[(i + 1) % one.size()]);
    return sum / 2;
}

Convex common_part(const Convex& one, const Convex& other) {
    Convex left = one;
    for (std::size_t i = 0; i < other.size() && !left.empty(); ++i) {
        const Point from = other[i], side = other[(i + 1) % other.size()] - from;
        const auto inside = [&](Point at) { return cross(side, at - from); };
        Convex cut;
        for (std::size_t j = 0; j < left.size(); ++j) {
            const Point a = left[j], b = left[(j + 1) % left.size()];
            const double in_a = inside(a), in_b = inside(b);
            if (in_a >= 0) cut.push_back(a);
            if ((in_a < 0) == (in_b < 0)) continue;
            const double share = in_a / (in_a - in_b);
            cut.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
        }
        left = std::move(cut);
    }
    return left;
}

double reach_of(const Convex& one, Point direction) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Point& at : one) most = std::max(most, dot(at, direction));
    return most;
}

Parting parting_of(const Convex& one, const Convex& other, Point along) {
    Parting best{-std::numeric_limits<double>::infinity(), {}};
    const Point between = middle_of(other) - middle_of(one);
    const auto consider = [&](Point way) {
        if (dot(way, between) < 0) way = {-way.x, -way.y};
        const double room = -reach_of(other, {-way.x, -way.y}) - reach_of(one, way);
        if (room > best.room) best = {room, way};
    };
    if (along.x != 0 || along.y != 0) {
        consider(along);
        return best;
    }
    const auto consider_sides = [&](const Convex& of) {
        for (std::size_t i = 0; i < of.size(); ++i) {
            const Point side = of[(i + 1) % of.size()] - of[i];
            if (const double length = std::hypot(side.x, side.y); length > 0) consider({side.y / length, -side.x / length});
        }
    };
    consider_sides(one);
    consider_sides(other);
    // Two corners that face each other are apart by more than any side tells.
    if (best.room > 0) {
        double least = std::numeric_limits<double>::infinity();
        Point way{};
        for (const Point& a : one)
            for (const Point& b : other)
                if (const double off = distance(a, b); off < least) {
                    least = off;
                    way = b - a;
                }
        if (least > best.room && least > 0) consider({way.x / least, way.y / least});
    }
    if (!(best.room > -std::numeric_limits<double>::infinity())) consider({1, 0});
    return best;
}

}  // namespace tactics
