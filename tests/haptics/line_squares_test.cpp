// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/line_squares.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <random>
#include <set>

#include "tests/haptics/plot_lines.h"

namespace tactics::line_squares_test {
namespace {

constexpr double kFar = 4, kSide = 0.3;

// Strokes with ragged ends, a wave, level and upright lines, a star of all directions and a line of one point.
std::vector<std::vector<Line>> cases() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> ragged(0, 3), anywhere(0, 20);
    Line strokes, wave;
    for (int i = 0; i < 400; ++i) strokes.push_back({i / 20.0, i % 2 == 0 ? 10 + ragged(random) : -ragged(random)});
    for (int i = 0; i <= 100; ++i) wave.push_back({i / 5.0, 6 + 5 * std::sin(i / 9.0)});
    std::vector<Line> star = {{{3, 3}}}, cloud;
    for (int i = 0; i < 24; ++i) {
        const double turn = i * std::numbers::pi / 12;
        star.push_back({{8, 8}, {8 + 7 * std::cos(turn), 8 + 7 * std::sin(turn)}});
    }
    for (int i = 0; i < 200; ++i) cloud.push_back({{anywhere(random), anywhere(random)}, {anywhere(random), anywhere(random)}});
    return {{strokes}, {wave}, {{{0, 0}, {20, 0}}, {{5, -3}, {5, 3}}}, star, cloud};
}

TEST(LineSquares, EachSquareHasItsNearestAndAllThatCanBeNearest) {
    for (const std::vector<Line>& lines : cases()) {
        const std::vector<LineSegment> segments = segments_of(lines);
        const LineSquares squares = squares_round(segments, kFar, kSide, 1'000'000);
        const auto away = [&](const LineSegment& one, Point at) { return distance(place_on(one, nearest_along(one, at)), at); };
        for (const bool whole : {false, true}) {
            std::map<std::pair<std::size_t, std::size_t>, double> met;
            std::mt19937 random(3);
            std::uniform_real_distribution<double> within(0, 1);
            const auto square = [&](std::size_t column, std::size_t row, double nearest, const std::vector<FoundSegment>& found) {
                const auto x = static_cast<double>(column), y = static_cast<double>(row);
                ASSERT_TRUE(met.emplace(std::pair(column, row), nearest).second);
                if (!whole || random() % 8 != 0) return;
                // Wherever in the square, one of them is as near as any, and no other is as near as it.
                const Point at = squares.middle(x + within(random) - 0.5, y + within(random) - 0.5);
                std::set<std::uint32_t> known;
                double least = INFINITY;
                for (const FoundSegment& one : found) {
                    known.insert(one.segment);
                    least = std::min(least, away(segments[one.segment], at));
                    ASSERT_NEAR(one.distance, away(segments[one.segment], squares.middle(x, y)), 1e-9);
                }
                for (std::uint32_t i = 0; i < segments.size(); ++i)
                    ASSERT_TRUE(known.contains(i) || away(segments[i], at) > least);
            };
            // Nobody asks for the lowest rows.
            constexpr std::size_t kLowest = 5;
            const auto wanted = [](std::size_t, std::size_t row, std::size_t size) { return row + size > kLowest; };
            SquareDescent(segments, squares, kFar, whole, square, wanted).run();
            for (std::size_t row = kLowest; row < squares.rows; ++row)
                for (std::size_t column = 0; column < squares.columns; ++column) {
                    const Point middle = squares.middle(static_cast<double>(column), static_cast<double>(row));
                    const double naive = naive_distance(lines, {middle.x, middle.y, 0});
                    const auto told = met.find({column, row});
                    ASSERT_TRUE(told != met.end() || !(naive < kFar));
                    ASSERT_NEAR(told == met.end() ? naive : told->second, naive, 1e-9);
                }
            for (const auto& [place, nearest] : met) ASSERT_GE(place.second + 1, kLowest);
        }
    }
}

TEST(LineSquares, NoSquareBesideASegmentIsPassed) {
    for (const std::vector<Line>& lines : cases())
        for (const double within : {0.02, kSide / 2, 1.0}) {
            const std::vector<LineSegment> segments = segments_of(lines);
            const LineSquares squares = squares_round(segments, kFar, kSide, 1'000'000);
            std::set<std::array<std::size_t, 3>> met;
            each_square_beside(segments, squares, within,
                               [&](std::size_t column, std::size_t row, double across, const LineSegment& segment) {
                                   const Point at = squares.middle(static_cast<double>(column), static_cast<double>(row));
                                   const double away = distance(place_on(segment, nearest_along(segment, at)), at);
                                   ASSERT_LE(across, away + 1e-9);
                                   ASSERT_LT(away, 2 * within + 1e-9);  // not many that are farther
                                   met.insert({static_cast<std::size_t>(&segment - segments.data()), column, row});
                               });
            for (std::size_t i = 0; i < segments.size(); i += 3)
                for (std::size_t row = 0; row < squares.rows; ++row)
                    for (std::size_t column = 0; column < squares.columns; ++column) {
                        const Point at = squares.middle(static_cast<double>(column), static_cast<double>(row));
                        const double away = distance(place_on(segments[i], nearest_along(segments[i], at)), at);
                        ASSERT_TRUE(away >= within || met.contains({i, column, row}));
                    }
        }
}

}  // namespace
}  // namespace tactics::line_squares_test
