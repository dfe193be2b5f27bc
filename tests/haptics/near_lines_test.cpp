// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/near_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/haptics/plot_lines.h"

namespace tactics::near_lines_test {
namespace {

// A few strokes; lines so close that hundreds are near a finger at once, as one that goes up and down, and in pieces that do not
// hang together.
TEST(NearLines, TheNearestPlaceIsFoundAsASearchThroughAllSays) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> up(38, 42), x(-12, 32), y(22, 62), z(-4, 12);
    Line line;
    for (int i = 0; i <= 2000; ++i) line.push_back({i / 100.0, up(random)});
    std::vector<Line> pieces;
    for (std::size_t i = 0; i + 1 < line.size(); i += 2) pieces.push_back({line[i], line[i + 1]});
    const std::vector<Line> few = {{{0, 30}, {7, 45}, {7, 45}, {20, 38}}, {{3, 3}}, {{0, 50}, {20, 50}}};
    for (const auto& lines : {few, {line}, pieces})
        for (const double far : {2.0, 10.0}) {
            const NearLines near(lines, far);
            for (int i = 0; i < 3000; ++i) {
                const Point3 at{x(random), y(random), i % 2 == 0 ? 0 : z(random)};
                const double least = naive_distance(lines, at);
                const Nearness told = near.at(at);
                ASSERT_EQ(told.within, least < far);
                if (!told.within) continue;
                ASSERT_NEAR(told.distance, least, 1e-9);
                ASSERT_NEAR(std::hypot(at.x - told.place.x, at.y - told.place.y, at.z), least, 1e-9);
                const Point a = lines[told.line][told.index], b = lines[told.line][told.index + 1];
                ASSERT_NEAR(distance(a, told.place) + distance(told.place, b), distance(a, b), 1e-9);
            }
        }
}

TEST(NearLines, OfNothingNothingIsTold) {
    EXPECT_FALSE(NearLines(std::vector<Line>{}).at({}).within);
    EXPECT_FALSE(NearLines({{{1, 1}}}).at({1, 1, 0}).within);
    EXPECT_FALSE(NearLines({{{1, 1}, {2, 2}}}).at({std::nan(""), 1, 0}).within);
}

}  // namespace
}  // namespace tactics::near_lines_test
