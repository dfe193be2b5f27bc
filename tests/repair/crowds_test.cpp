// SPDX-License-Identifier: Apache-2.0
// Crowds of edges, thinned before anything else is mended.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tactics/repair/means.h"

namespace tactics::crowds_test {
namespace {

// An outline across a wood of scratches, each weaker and up to 10 mm long.
Drawing wood(int scratches, float strength) {
    Drawing drawing;
    drawing.width = 180;
    drawing.height = 120;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> along(5, 175), down(5, 115), turn(0, 2 * std::numbers::pi), length(2, 10);
    for (int i = 0; i < scratches; ++i) {
        const Point from{along(random), down(random)};
        const double angle = turn(random), mm = length(random);
        drawing.strokes.push_back({{from, {from.x + mm * std::cos(angle), from.y + mm * std::sin(angle)}},
                                   false,
                                   LineClass::normal,
                                   strength * static_cast<float>(1 + i % 7) / 7});
    }
    drawing.strokes.push_back({{{20, 60}, {90, 40}, {160, 60}}, false, LineClass::normal, strength});
    return drawing;
}

// The share of the square of 26 mm round a point that lines take with their gaps, by many small steps.
double ground_round(const Drawing& drawing, const Medium& medium, Point at) {
    constexpr double kHalf = 13, kStep = 0.1;
    double room = 0;
    for (const Stroke& stroke : drawing.strokes)
        for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
            const Point a = stroke.points[i], b = stroke.points[i + 1];
            const double length = distance(a, b);
            for (double s = 0; s < length; s += kStep) {
                const Point p{a.x + s / length * (b.x - a.x), a.y + s / length * (b.y - a.y)};
                if (std::abs(p.x - at.x) < kHalf && std::abs(p.y - at.y) < kHalf)
                    room += kStep * (width_of(stroke.line, medium) + medium.gap);
            }
        }
    const double across = std::min(drawing.width, at.x + kHalf) - std::max(0.0, at.x - kHalf);
    const double down = std::min(drawing.height, at.y + kHalf) - std::max(0.0, at.y - kHalf);
    return room / (across * down);
}

TEST(Crowds, LeaveTheOutlineAndRoomForIt) {
    const Medium& medium = media().front();
    Drawing drawing = wood(1500, 100);
    const std::size_t before = drawing.strokes.size();
    const std::vector<Point> outline = drawing.strokes.back().points;
    const Mends mends = thin_crowds(drawing, medium);
    ASSERT_EQ(drawing.strokes.back().points.size(), outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) EXPECT_EQ(distance(drawing.strokes.back().points[i], outline[i]), 0);
    EXPECT_GT(mends.size(), before / 2);
    EXPECT_EQ(drawing.strokes.size() + mends.size(), before);
    double most = 0, all = 0;
    for (const Stroke& stroke : drawing.strokes) {
        const double ground = ground_round(drawing, medium, stroke.points[0]);
        most = std::max(most, ground);
        all += ground / static_cast<double>(drawing.strokes.size());
    }
    EXPECT_LT(most, 0.9);
    EXPECT_LT(all, 0.65);
    EXPECT_GT(all, 0.45);  // and no more than that went
}

TEST(Crowds, LoseTheWeakestFirst) {
    const Medium& medium = media().front();
    Drawing drawing = wood(1500, 100);
    const auto share = [&](float least) {
        const auto strong =
            std::count_if(drawing.strokes.begin(), drawing.strokes.end(), [&](const Stroke& s) { return s.strength >= least; });
        return static_cast<double>(strong) / static_cast<double>(drawing.strokes.size());
    };
    const double before = share(70);
    thin_crowds(drawing, medium);
    EXPECT_GT(share(70), 1.4 * before);
}

TEST(Crowds, AreOnlyWhereThereAreMany) {
    const Medium& medium = media().front();
    Drawing drawing = wood(100, 100);
    const std::size_t before = drawing.strokes.size();
    EXPECT_TRUE(thin_crowds(drawing, medium).empty());
    EXPECT_EQ(drawing.strokes.size(), before);
}

TEST(Crowds, OfDrawnLinesStay) {
    const Medium& medium = media().front();
    Drawing drawing = wood(1500, 0);  // no strength: not found as edges
    const std::size_t before = drawing.strokes.size();
    EXPECT_TRUE(thin_crowds(drawing, medium).empty());
    EXPECT_EQ(drawing.strokes.size(), before);
}

TEST(Crowds, AreThinnedOnce) {
    const Medium& medium = media().front();
    Drawing drawing = wood(1500, 100);
    thin_crowds(drawing, medium);
    EXPECT_TRUE(thin_crowds(drawing, medium).empty());
}

TEST(Crowds, OutsideThePageAndOfAPointDoNoHarm) {
    const Medium& medium = media().front();
    Drawing drawing = wood(1500, 100);
    drawing.strokes.push_back({{{-5, -5}, {400, 300}}, false, LineClass::normal, 1});
    drawing.strokes.push_back({{{90, 60}}, false, LineClass::normal, 1});
    drawing.strokes.push_back({{}, false, LineClass::normal, 1});
    const Mends mends = thin_crowds(drawing, medium);
    EXPECT_GT(mends.size(), 700u);
}

}  // namespace
}  // namespace tactics::crowds_test
