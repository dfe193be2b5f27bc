// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/course.h"

#include <gtest/gtest.h>

namespace tactics::course_test {
namespace {

// A zigzag that grows, with places between that add nothing: of each piece the farthest point is its last but one, so that the
// whole is looked at for each. Long enough for that to be given up, and the law holds all the same.
TEST(Course, OfALineWhereEachPointIsFartherStaysWithinTheTolerance) {
    constexpr double kTolerance = 0.1;
    constexpr int kTurns = 12'000;
    std::vector<Point> points;
    for (int i = 0; i < kTurns; ++i) {
        const double x = 0.01 * i, y = (i % 2 == 0 ? 1 : -1) * (1 + 0.01 * i);
        points.push_back({x, y});
        points.push_back({x + 0.005, 0});  // on the way to the next turn
    }
    std::vector<bool> keep(points.size(), false);
    keep.front() = keep.back() = true;
    keep_course(points, 0, points.size() - 1, kTolerance, keep);
    std::size_t kept = 0, from = 0;
    for (std::size_t to = 1; to < points.size(); ++to) {
        if (!keep[to]) continue;
        for (std::size_t i = from + 1; i < to; ++i)
            ASSERT_LE(distance_to_segment(points[i], points[from], points[to]), kTolerance) << i;
        from = to;
        ++kept;
    }
    EXPECT_LT(kept, kTurns * 21 / 20);
    EXPECT_GT(kept, kTurns * 9 / 10);
}

}  // namespace
}  // namespace tactics::course_test
