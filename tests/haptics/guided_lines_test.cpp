// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/guided_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tactics::guided_lines_test {
namespace {

constexpr double kResolution = 0.05;

PlotFrame frame() {
    PlotFrame frame;
    frame.x = {0, 100, false, {}};
    frame.y = {0, 80, false, {}};
    return frame;
}

GuidedLines lines_of(const Plot& plot) { return {plot, frame(), felt_lines(plot, frame(), kResolution), kResolution}; }

Plot plot_of(std::vector<PlotCurve> curves) {
    Plot plot;
    plot.curves = std::move(curves);
    return plot;
}

PlotCurve walk(std::mt19937& random, int points, bool ascends) {
    std::uniform_real_distribution<double> x(0, 100), step(-6, 6);
    PlotCurve curve;
    double y = 40;
    for (int i = 0; i < points; ++i) {
        y = std::clamp(y + step(random), 0.0, 80.0);
        curve.points.push_back({ascends ? 100.0 * i / (points - 1) : x(random), y});
    }
    return curve;
}

// Walks along the segments one by one.
Point naive_place(const std::vector<Point>& line, double along) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double length = distance(line[i], line[i + 1]);
        if (along <= length)
            return {line[i].x + along / length * (line[i + 1].x - line[i].x),
                    line[i].y + along / length * (line[i + 1].y - line[i].y)};
        along -= length;
    }
    return line.back();
}

TEST(GuidedLines, APlaceIsSoFarAlongItsLine) {
    std::mt19937 random(1);
    const Plot plot = plot_of({walk(random, 60, true), walk(random, 40, false)});
    const FeltLines felt = felt_lines(plot, frame(), kResolution);
    const GuidedLines lines = lines_of(plot);
    const NearLines near(felt.lines);
    for (std::uint32_t line = 0; line < felt.lines.size(); ++line) {
        EXPECT_EQ(lines.curve_of(line), line);
        for (double share = 0; share <= 1; share += 0.01) {
            const double along = share * lines.length(line);
            const Point place = lines.at({line, along});
            EXPECT_LT(distance(place, naive_place(felt.lines[line], along)), 1e-9);
            const Nearness found = near.at({place.x, place.y, 0});
            ASSERT_TRUE(found.within);
            EXPECT_LT(distance(lines.at(lines.place_of(found)), place), 1e-6);
        }
    }
}

// Against a walk along all segments from the first.
TEST(GuidedLines, ACurveIsFirstMetWhereItComesByFirst) {
    std::mt19937 random(2);
    for (int round = 0; round < 40; ++round) {
        PlotCurve curve = walk(random, 30, round % 2 == 0);
        if (round % 4 == 3) curve.points[7].x = curve.points[6].x;  // upright
        if (round % 3 == 2) curve.gaps = {10, 20};
        const Plot plot = plot_of({curve});
        const FeltLines felt = felt_lines(plot, frame(), kResolution);
        const GuidedLines lines = lines_of(plot);
        for (double x = -1; x <= 101; x += 0.37) {
            std::optional<Point> first;
            for (const auto& line : felt.lines)
                for (std::size_t i = 0; i + 1 < line.size() && !first; ++i) {
                    const Point a = line[i], b = line[i + 1];
                    if (x < std::min(a.x, b.x) || x > std::max(a.x, b.x)) continue;
                    first = a.x == b.x ? a : Point{x, a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y)};
                }
            const auto met = lines.first_at(0, x);
            ASSERT_EQ(met.has_value(), first.has_value()) << x;
            if (!met) continue;
            EXPECT_LT(distance(lines.at(*met), *first), 1e-6) << x;
        }
    }
}

// What a turn is: between two of them, and before the first and behind the last, the curve nowhere goes back by as much as
// counts, and each differs from the next by as much.
TEST(GuidedLines, TurnsAreAllThatStandOutAndNoMore) {
    std::mt19937 random(3);
    for (int round = 0; round < 30; ++round) {
        PlotCurve curve = walk(random, 200, true);
        if (round % 2 == 1)
            for (PlotPoint& point : curve.points) point.y = 40 + (point.y - 40) / 12;  // mostly noise
        const Plot plot = plot_of({curve});
        const GuidedLines lines = lines_of(plot);
        const auto& points = curve.points;
        std::vector<std::size_t> at;
        for (const CurveTurn& turn : lines.turns(0)) {
            const auto found = std::find_if(points.begin(), points.end(),
                                            [&](const PlotPoint& p) { return p.x == turn.value.x && p.y == turn.value.y; });
            ASSERT_NE(found, points.end());
            at.push_back(static_cast<std::size_t>(found - points.begin()));
            EXPECT_LE(distance(lines.at(turn.at), {frame().across(turn.value.x), frame().down(turn.value.y)}), kResolution);
        }
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            const CurveTurn &a = lines.turns(0)[i], &b = lines.turns(0)[i + 1];
            EXPECT_NE(a.highest, b.highest);
            EXPECT_LT(a.at.along, b.at.along);
            EXPECT_GE((a.value.y - b.value.y) * (a.highest ? 1 : -1), kLeastTurn - 1e-9);
        }
        // The first and the last differ as much from something before them and behind them.
        if (!at.empty()) {
            const auto stands_out = [&](std::size_t turn, std::size_t from, std::size_t to) {
                const double way = lines.turns(0)[turn == at.front() ? 0 : at.size() - 1].highest ? 1 : -1;
                double most = 0;
                for (std::size_t a = from; a <= to; ++a) most = std::max(most, (points[turn].y - points[a].y) * way);
                return most >= kLeastTurn - 1e-9;
            };
            EXPECT_TRUE(stands_out(at.front(), 0, at.front()));
            EXPECT_TRUE(stands_out(at.back(), at.back(), points.size() - 1));
        }
        for (std::size_t i = 0; i <= at.size(); ++i) {
            const std::size_t from = i == 0 ? 0 : at[i - 1], to = i == at.size() ? points.size() - 1 : at[i];
            if (at.empty()) break;
            const bool rises = i == at.size() ? !lines.turns(0)[i - 1].highest : lines.turns(0)[i].highest;
            for (std::size_t a = from; a <= to; ++a)
                for (std::size_t b = a; b <= to; ++b)
                    ASSERT_LT((points[a].y - points[b].y) * (rises ? 1 : -1), kLeastTurn + 1e-9);
        }
    }
}

// A wave under noise that is finer than any finger, however high it is.
TEST(GuidedLines, AMillionPointsOfNoiseAreNotAMillionTurns) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> noise(-1.5, 1.5);
    PlotCurve curve;
    for (int i = 0; i <= 100'000; ++i) curve.points.push_back({i / 1000.0, 40 + 30 * std::sin(i / 1e4) + noise(random)});
    const GuidedLines lines = lines_of(plot_of({curve}));
    ASSERT_EQ(lines.turns(0).size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(lines.turns(0)[i].value.x, (static_cast<double>(i) + 0.5) * std::acos(-1) * 10, 3);
    // Its middle is the wave, a mean of places; the stop and the ends are met.
    EXPECT_GT(lines.winding(0), 10);
    const double whole = lines.length(0);
    const LinePlace stop{0, 0.7 * whole};
    for (double share = 0.02; share < 0.69; share += 0.01) {
        const LinePlace place{0, share * whole};
        const Point middle = lines.middle_at(place, stop);
        const double half = std::min({lines.winding(0) * kLeastTurn / 2, place.along, stop.along - place.along});
        Point mean;
        constexpr int kPlaces = 20'000;
        for (int i = 0; i < kPlaces; ++i) {
            const Point one = lines.at({0, place.along + half * (2 * (i + 0.5) / kPlaces - 1)});
            mean = {mean.x + one.x / kPlaces, mean.y + one.y / kPlaces};
        }
        ASSERT_LT(distance(middle, mean), 0.01);
        ASSERT_LT(std::abs(middle.y - frame().down(40 + 30 * std::sin(middle.x / 10))), 1);
    }
    EXPECT_EQ(distance(lines.middle_at(stop, stop), lines.at(stop)), 0);
    EXPECT_EQ(distance(lines.middle_at({0, 0}, stop), lines.at({0, 0})), 0);
    // What can be told has no middle.
    const GuidedLines plain = lines_of(plot_of({{"", {{0, 0}, {50, 80}, {100, 0}}}}));
    EXPECT_EQ(plain.winding(0), 1);
    EXPECT_EQ(distance(plain.middle_at({0, 60}, {0, 100}), plain.at({0, 60})), 0);
}

TEST(GuidedLines, TheNextTurnIsBeyond) {
    const GuidedLines lines = lines_of(plot_of({{"", {{0, 10}, {20, 30}, {40, 5}, {60, 60}, {100, 0}}}}));
    ASSERT_EQ(lines.turns(0).size(), 3u);
    const CurveTurn* first = lines.next_turn({0, 0}, true);
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->value.x, 20);
    EXPECT_TRUE(first->highest);
    EXPECT_EQ(lines.next_turn(first->at, true)->value.x, 40);
    EXPECT_EQ(lines.next_turn(first->at, false), nullptr);
    EXPECT_EQ(lines.next_turn({0, lines.length(0)}, true), nullptr);
    EXPECT_EQ(lines.next_turn({0, lines.length(0)}, false)->value.x, 60);
}

// The ends of a piece are no turns, and one point is a place.
TEST(GuidedLines, GapsBeginAnew) {
    PlotCurve curve{"", {{0, 10}, {10, 40}, {20, 40}, {30, 10}, {40, 10}, {50, 40}, {60, 10}}};
    curve.gaps = {2, 4};
    const GuidedLines lines = lines_of(plot_of({curve, {"", {{5, 5}}}, {"", {{0, 1}, {9, 1}}}}));
    ASSERT_EQ(lines.curves(), 3u);
    EXPECT_EQ(lines.end_line(0) - lines.first_line(0), 3u);
    EXPECT_TRUE(lines.has_place(1));
    EXPECT_EQ(lines.length(lines.first_line(1)), 0);
    EXPECT_TRUE(lines.has_place(2));
    ASSERT_EQ(lines.turns(0).size(), 1u);
    EXPECT_EQ(lines.turns(0)[0].value.x, 50);
    EXPECT_EQ(lines.turns(0)[0].at.line, 2u);
    EXPECT_FALSE(lines.first_at(0, 15));
    EXPECT_TRUE(lines.first_at(0, 25));
    EXPECT_TRUE(lines.first_at(1, 5));
    EXPECT_FALSE(lines.first_at(1, 5.01));
    EXPECT_FALSE(lines_of(plot_of({{"", {}}})).has_place(0));
    EXPECT_TRUE(lines_of(plot_of({})).empty());
}

TEST(GuidedLines, FarFromAllCurvesTheNearestIsKnownRoughly) {
    const GuidedLines lines = lines_of(plot_of({{"", {{0, 0}, {100, 0}}}, {"", {{0, 80}, {100, 80}}}}));
    EXPECT_EQ(lines.roughly_nearest({50, 20}).line, 1u);  // y is downwards
    EXPECT_EQ(lines.roughly_nearest({50, 60}).line, 0u);
    EXPECT_NEAR(lines.at(lines.roughly_nearest({37, 60})).x, 37, 0.2);
}

}  // namespace
}  // namespace tactics::guided_lines_test
