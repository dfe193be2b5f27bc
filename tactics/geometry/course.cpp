// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/course.h"

#include <utility>

namespace tactics {

namespace {

// In a line where the farthest point is always the last but one (a growing zigzag), all points would be visited for each. When
// this is detected, the rest is halved first, which keeps a few more points.
constexpr std::size_t kLooks = 10'000'000, kLooksEach = 100, kShort = 1000;

}  // namespace

double distance_to_segment(Point p, Point a, Point b) { return distance(p, nearest_on_segment(p, a, b)); }

void keep_course(const std::vector<Point>& points, std::size_t from, std::size_t to, double tolerance, std::vector<bool>& keep) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{from, to}};
    const std::size_t most = kLooks + kLooksEach * (to - from);
    std::size_t looks = 0;
    while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        if (looks > most && b - a > kShort) {
            const std::size_t middle = a + (b - a) / 2;
            keep[middle] = true;
            open.emplace_back(a, middle);
            open.emplace_back(middle, b);
            continue;
        }
        looks += b - a;
        double farthest = tolerance;
        std::size_t split = 0;
        for (std::size_t i = a + 1; i < b; ++i)
            if (const double d = distance_to_segment(points[i], points[a], points[b]); d > farthest) {
                farthest = d;
                split = i;
            }
        if (split == 0) continue;
        keep[split] = true;
        open.emplace_back(a, split);
        open.emplace_back(split, b);
    }
}

std::vector<Point> course_of(const std::vector<Point>& points, double tolerance) {
    if (points.size() < 3) return points;
    std::vector<bool> keep(points.size(), false);
    keep.front() = keep.back() = true;
    keep_course(points, 0, points.size() - 1, tolerance, keep);
    std::vector<Point> course;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (keep[i]) course.push_back(points[i]);
    return course;
}

}  // namespace tactics
