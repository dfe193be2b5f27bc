// SPDX-License-Identifier: Apache-2.0
// Dashed lines that turn at measurements, and what is too even to be the points of a plot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "filters/dash_rows.h"
#include "filters/known_parts.h"
#include "tactics/geometry/course.h"
#include "tests/filters/pictures.h"

namespace tactics::dash_corners_test {
namespace {

// Black where the way along the line is within one of its marks: ink and gap by turns.
Image dashed(int width, int height, const std::vector<Point>& line, const std::vector<double>& marks, double half) {
    double period = 0;
    for (const double mark : marks) period += mark;
    return pictures::drawn(width, height, [&](int x, int y) {
        double before = 0;
        const Point at{x + 0.5, y + 0.5};
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Point a = line[i - 1], b = line[i];
            const double length = distance(a, b);
            const double t = ((at.x - a.x) * (b.x - a.x) + (at.y - a.y) * (b.y - a.y)) / length;
            if (t >= 0 && t <= length && distance_to_segment(at, a, b) <= half) {
                double along = std::fmod(before + t, period);
                for (std::size_t k = 0; k < marks.size(); along -= marks[k++])
                    if (along < marks[k]) return k % 2 == 0 ? 0 : 255;
            }
            before += length;
        }
        return 255;
    });
}

const std::vector<Point> kZigzag{{20, 150}, {100, 60}, {190, 170}, {260, 90}, {380, 140}};
const std::vector<double> kLong{13, 7}, kDots{4, 6};

TEST(DashCorners, ARowTurnsWhereItsLineDoes) {
    for (const auto& marks : {kLong, kDots}) {
        const Image picture = dashed(400, 220, kZigzag, marks, 2);
        const auto rows = dash_rows_in(picture, picture, {40, 6, 14});
        ASSERT_EQ(rows.size(), 1u);
        const auto [first, last] = std::minmax({rows[0].points.front().x, rows[0].points.back().x});
        EXPECT_LT(first, 30);
        EXPECT_GT(last, 370);
    }
}

// Rows of a texture end beside each other, and do not go on there and back.
TEST(DashCorners, ATextureIsNoLine) {
    const Image picture = pictures::drawn(220, 120, [](int x, int y) { return x % 12 < 4 && y % 12 < 4 && x > 8 ? 0 : 255; });
    const auto rows = dash_rows_in(picture, picture, {40, 6, 14});
    EXPECT_GT(rows.size(), 5u);
}

TEST(DashCorners, LargeDotsOfALineAreNoPoints) {
    Image picture = dashed(400, 220, kZigzag, {6, 8}, 3);
    const KnownParts dots = take_known_parts(picture, std::array<int, 3>{255, 255, 255});
    EXPECT_EQ(dots.marks, 0u);
    EXPECT_EQ(dots.strokes.size(), 1u);
    // With more room between them than a dotted line has they are measurements.
    Image far = dashed(400, 220, kZigzag, {6, 26}, 3);
    const KnownParts points = take_known_parts(far, std::array<int, 3>{255, 255, 255});
    EXPECT_GT(points.marks, 0u);
}

}  // namespace
}  // namespace tactics::dash_corners_test
