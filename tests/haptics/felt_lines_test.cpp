// SPDX-License-Identifier: Apache-2.0
// What is left of the curves of a plot for a device of some resolution.
#include <gtest/gtest.h>

#include <random>

#include "tests/haptics/plot_lines.h"

namespace tactics::felt_lines_test {
namespace {

TEST(FeltLines, KeepWithinTheResolutionWhatTheyDrop) {
    for (const double resolution : {0.055, 0.5}) {
        Plot plot;
        PlotCurve curve;
        std::mt19937 random(8);
        std::normal_distribution<double> step(0, 0.004);
        double y = 0;
        for (int i = 0; i < 20'000; ++i) {
            y = std::clamp(y + step(random), -4.5, 4.5);
            curve.points.push_back({i / 2000.0, y + (i % 5000 == 77 ? 0.4 : 0)});
        }
        curve.gaps = {9000};
        plot.curves.push_back(curve);
        const FeltLines felt = felt_lines(plot, frame(), resolution);
        ASSERT_EQ(felt.lines.size(), 2u);
        EXPECT_EQ(felt.points, 20'000u);
        EXPECT_LT(felt.kept, 20'000u);
        double worst = 0;
        for (std::size_t i = 0; i < curve.points.size(); i += 7) {
            const Point3 at = frame().place(curve.points[i].x, curve.points[i].y);
            worst = std::max(worst, naive_distance({felt.lines[i < 9000 ? 0 : 1]}, at));
        }
        EXPECT_LE(worst, resolution);
        // And nothing was made up: every kept point is one of the curve.
        EXPECT_LE(std::abs(felt.lines[0].back().x - frame().across(curve.points[8999].x)), 1e-12);
        EXPECT_LE(std::abs(felt.lines[1].front().x - frame().across(curve.points[9000].x)), 1e-12);
    }
}

// Noise: what a finger can be told of them is a stroke a column, and no place of the curve is left out.
TEST(FeltLines, OfNoiseKeepAStrokeForEachColumn) {
    constexpr double kResolution = 0.055;
    Plot plot;
    PlotCurve curve;
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 1.2);
    for (int i = 0; i < 200'000; ++i) curve.points.push_back({i / 2e4, std::clamp(noise(random), -4.5, 4.5)});
    plot.curves.push_back(curve);
    const FeltLines felt = felt_lines(plot, frame(), kResolution);
    ASSERT_EQ(felt.lines.size(), 1u);
    EXPECT_LT(felt.kept, 2 * 120 / (kResolution / 2) + 10);
    double worst = 0;
    for (std::size_t i = 0; i < curve.points.size(); i += 29)
        worst = std::max(worst, naive_distance(felt.lines, frame().place(curve.points[i].x, curve.points[i].y)));
    EXPECT_LE(worst, kResolution);
    EXPECT_LE(std::abs(felt.lines[0].back().x - frame().across(curve.points.back().x)), 1e-12);
}

TEST(FeltLines, StepsAndBarsHaveTheirUprights) {
    Plot plot;
    plot.curves.push_back({"s", {{0, 1}, {5, 3}, {10, -2}}, Joining::steps, {}});
    plot.curves.push_back({"b", {{0, 2}, {5, 4}, {10, 0}}, Joining::bars, {}});
    const FeltLines felt = felt_lines(plot, frame(), 0.1);
    ASSERT_EQ(felt.lines.size(), 2u);
    const auto near = [&](std::size_t line, double x, double y) {
        return naive_distance({felt.lines[line]}, frame().place(x, y)) < 0.11;
    };
    EXPECT_TRUE(near(0, 4, 1) && near(0, 5, 2) && near(0, 9, 3) && near(0, 10, 0));
    EXPECT_FALSE(near(0, 2.5, 2));
    EXPECT_TRUE(near(1, 0, 1) && near(1, 3, 2) && near(1, 5, 1) && near(1, 5, 3.5) && near(1, 8, 4) && near(1, 10, 2));
    EXPECT_FALSE(near(1, 3, 0));
}

}  // namespace
}  // namespace tactics::felt_lines_test
