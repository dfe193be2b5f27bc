// SPDX-License-Identifier: Apache-2.0
#include "filters/middle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tactics {

namespace {

// What was ink before it was thinned keeps a mark: see InkMap.
bool was_ink(const InkMap& map, double x, double y) {
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    return ix >= 0 && iy >= 0 && ix < map.width && iy < map.height && map.row(iy)[ix] != 0;
}

// How far the ink goes from `at` in that direction, to a quarter of a pixel; `most` or more: it is no side of a line.
double reach(const InkMap& map, Point at, Point way, double most) {
    double r = 0.5;
    while (r < most && was_ink(map, at.x + r * way.x, at.y + r * way.y)) r += 0.5;
    return was_ink(map, at.x + (r - 0.25) * way.x, at.y + (r - 0.25) * way.y) ? r : r - 0.25;
}

std::uint32_t pixel_at(const Skeleton& skeleton, Point at) {
    return skeleton.pixel_at(static_cast<int>(at.x), static_cast<int>(at.y));
}

constexpr std::ptrdiff_t kAside = 4;  // points on either side that a direction is taken from

// Takes off the bent last points of a line, as many as the ink is half wide. Gives how far they went.
double cut_end(std::vector<Point>& points, const Skeleton& skeleton) {
    double half = 0;
    const std::size_t look = std::min<std::size_t>(points.size(), 2 * kAside);
    for (std::size_t i = points.size() - look; i < points.size(); ++i)
        half = std::max(half, skeleton.half_width(pixel_at(skeleton, points[i])));
    const auto bent = static_cast<std::size_t>(half);
    if (bent == 0 || points.size() < 3 * bent + 2 * kAside) return 0;
    const Point end = points.back();
    points.resize(points.size() - bent);
    return distance(end, points.back());
}

// Goes on by so much in the direction from the mean of the points 12 to 8 before the end to the mean of the last 4.
void go_on(std::vector<Point>& points, double length) {
    if (length <= 0) return;
    const std::size_t n = points.size(), near = std::min<std::size_t>(4, n), far = std::min<std::size_t>(12, n);
    Point a{}, b{};
    for (std::size_t i = 1; i <= near; ++i) {
        const Point& early = points[n - far + i - 1];
        const Point& late = points[n - i];
        a = {a.x + early.x, a.y + early.y};
        b = {b.x + late.x, b.y + late.y};
    }
    const double base = distance(a, b);
    if (base <= 0) return;
    const Point end = points.back();
    for (double r = std::min(1.0, length);; r = std::min(r + 1, length)) {
        points.push_back({end.x + r * (b.x - a.x) / base, end.y + r * (b.y - a.y) / base});
        if (r >= length) return;
    }
}

void shift_points(std::vector<Point>& points, bool closed, const Skeleton& skeleton) {
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    if (n < 2 * kAside + 1) return;
    const std::vector<Point> old = points;
    const auto at = [&](std::ptrdiff_t i) {
        return old[static_cast<std::size_t>(closed ? (i + n) % n : std::clamp<std::ptrdiff_t>(i, 0, n - 1))];
    };
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const std::uint32_t pixel = pixel_at(skeleton, old[static_cast<std::size_t>(i)]);
        if (!skeleton.was_wider(pixel)) continue;
        const double half = skeleton.half_width(pixel);
        const Point a = at(i - kAside), b = at(i + kAside);
        const double length = distance(a, b);
        if (length <= 0) continue;
        const Point normal{-(b.y - a.y) / length, (b.x - a.x) / length};
        const double most = 1.5 * half + 1.5;  // layers count along rows and columns: a slanted line is wider by up to 1.4
        const double one = reach(skeleton.map, at(i), normal, most),
                     other = reach(skeleton.map, at(i), {-normal.x, -normal.y}, most);
        if (one >= most || other >= most) continue;
        const double shift = std::clamp((one - other) / 2, -1.5, 1.5);
        points[static_cast<std::size_t>(i)] = {at(i).x + shift * normal.x, at(i).y + shift * normal.y};
    }
}

}  // namespace

void move_to_middle(PixelPath& path, const Skeleton& skeleton) {
    double cut[2] = {0, 0};
    for (const std::size_t side : {1u, 0u}) {  // the second time, the first end is the last
        if (!path.closed && path.free[side]) cut[side] = cut_end(path.points, skeleton);
        std::reverse(path.points.begin(), path.points.end());
    }
    shift_points(path.points, path.closed, skeleton);
    for (const std::size_t side : {1u, 0u}) {
        go_on(path.points, cut[side]);
        std::reverse(path.points.begin(), path.points.end());
    }
}

}  // namespace tactics
