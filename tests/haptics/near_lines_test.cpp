// SPDX-License-Identifier: Apache-2.0
// Lines so close that hundreds are near a finger at once.
#include "tactics/haptics/scenes/near_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/haptics/plot_lines.h"

namespace tactics {
namespace {

// One that goes up and down, and one of pieces that do not hang together.
TEST(NearLines, OfAThicketTheNearestPlaceIsFound) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> up(38, 42), x(0, 20), y(30, 50);
    std::vector<Point> line;
    for (int i = 0; i <= 2000; ++i) line.push_back({i / 100.0, up(random)});
    std::vector<std::vector<Point>> pieces;
    for (std::size_t i = 0; i + 1 < line.size(); i += 2) pieces.push_back({line[i], line[i + 1]});
    for (const auto& lines : {std::vector<std::vector<Point>>{line}, pieces}) {
        const NearLines near(lines, {});
        for (int i = 0; i < 1000; ++i) {
            const Point at{x(random), y(random)};
            const double least = naive_distance(lines, {at.x, at.y, 0});
            const Nearness told = near.at({at.x, at.y, 0});
            if (least > 9.9) continue;
            ASSERT_TRUE(told.within);
            ASSERT_NEAR(distance(at, told.place), least, 1e-9);
            ASSERT_LE(told.distance, least + 1e-9);
            ASSERT_GE(told.distance, least - NearLines::Reach{}.blend / 4 - 1e-9);
        }
    }
}

}  // namespace
}  // namespace tactics
