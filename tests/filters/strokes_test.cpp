// SPDX-License-Identifier: Apache-2.0
// The filters that choose among strokes and mend them: simplify, thicken.
#include <gtest/gtest.h>

#include "tactics/geometry/evidence.h"
#include "tests/filters/shapes.h"

namespace tactics::strokes_test {
namespace {

using shapes::drawn;
using shapes::line;

Drawing random_drawing(std::uint32_t seed, int count, bool strengths) {
    std::mt19937 random(seed);
    const auto number = [&](double most) { return static_cast<double>(random() % 10000) * most / 10000; };
    Drawing drawing{100, 60, {}, {}, {}};
    for (int i = 0; i < count; ++i) {
        Stroke stroke =
            line({{number(100), number(60)}}, strengths ? static_cast<float>(1 + number(80)) : 0.0f, random() % 4 == 0);
        const double turn = number(0.2) - 0.1;
        double angle = number(6.28);
        for (int k = static_cast<int>(random() % 60) + 2; k > 0; --k, angle += turn) {
            const Point at = stroke.points.back();
            stroke.points.push_back(
                {std::clamp(at.x + std::cos(angle), 0.0, 100.0), std::clamp(at.y + std::sin(angle), 0.0, 60.0)});
        }
        drawing.strokes.push_back(stroke);
    }
    return drawing;
}

TEST(Simplify, StaysWithinTheTolerance) {
    for (const double tolerance : {0.05, 0.3, 2.0}) {
        const Drawing before = random_drawing(7, 40, false);
        const Drawing after = drawn("simplify tolerance=" + std::to_string(tolerance), before);
        ASSERT_EQ(after.strokes.size(), before.strokes.size());
        for (std::size_t i = 0; i < before.strokes.size(); ++i) {
            EXPECT_EQ(after.strokes[i].closed, before.strokes[i].closed);
            EXPECT_GE(after.strokes[i].points.size(), before.strokes[i].closed ? 3u : 2u);
            EXPECT_LE(after.strokes[i].points.size(), before.strokes[i].points.size());
            for (const Point& p : before.strokes[i].points) EXPECT_LE(shapes::to_stroke(p, after.strokes[i]), tolerance + 1e-9);
            if (!before.strokes[i].closed) {
                EXPECT_EQ(after.strokes[i].points.front().x, before.strokes[i].points.front().x);
                EXPECT_EQ(after.strokes[i].points.back().y, before.strokes[i].points.back().y);
            }
        }
    }
}

TEST(Simplify, LeavesALineTwoPointsAndACircleFew) {
    Drawing drawing{100, 100, {line({}), line({}, 0, true)}, {Area{{{}}}}, {}};
    for (int i = 0; i < 100; ++i) {
        drawing.strokes[0].points.push_back({i * 1.0, i * 0.5});
        const Point on_circle{50 + 30 * std::cos(i * 0.0628318), 50 + 30 * std::sin(i * 0.0628318)};
        drawing.strokes[1].points.push_back(on_circle);
        drawing.areas[0].rings[0].push_back(on_circle);
    }
    const Drawing after = drawn("simplify tolerance=0.2", drawing);
    EXPECT_EQ(after.strokes[0].points.size(), 2u);
    EXPECT_LT(after.strokes[1].points.size(), 40u);
    EXPECT_GE(after.strokes[1].points.size(), 12u);
    EXPECT_EQ(after.areas[0].rings[0].size(), after.strokes[1].points.size());
}

TEST(Simplify, LoopsStayLoops) {
    Drawing drawing{
        10, 10, {line({{1, 1}, {1, 1}, {1, 1}, {1, 1}}, 0, true), line({{0, 0}, {5, 0}, {9, 0}, {4, 0.01}}, 0, true)}, {}, {}};
    for (const Stroke& stroke : drawn("simplify tolerance=5", drawing).strokes) EXPECT_EQ(stroke.points.size(), 3u);
}

TEST(Simplify, DropsShortLines) {
    const Drawing drawing{
        100, 100, {line({{0, 0}, {5, 0}}), line({{0, 5}, {3, 5}}), line({{0, 9}, {2, 9}, {2, 8}}, 0, true)}, {}, {}};
    EXPECT_EQ(drawn("simplify", drawing).strokes.size(), 3u);
    EXPECT_EQ(drawn("simplify shortest=4", drawing).strokes.size(), 2u);
    EXPECT_EQ(drawn("simplify shortest=5.1", drawing).strokes.size(), 1u);
}

TEST(Evidence, CountsStrengthAndLength) {
    const Stroke faint_and_long = line({{0, 0}, {400, 0}}, 20), strong_and_short = line({{0, 0}, {4, 0}}, 60),
                 unknown = line({{0, 0}, {900, 0}});
    EXPECT_GT(evidence_of(faint_and_long), evidence_of(strong_and_short));
    EXPECT_GT(evidence_of(strong_and_short), evidence_of(line({{0, 0}, {100, 0}}, 20)));
    EXPECT_EQ(by_evidence({unknown, strong_and_short, faint_and_long, strong_and_short}), (std::vector<std::size_t>{2, 1, 3, 0}));
}

TEST(Thicken, SetsTheClassOfAllOrOfTheStrongest) {
    const Drawing drawing{
        100,
        100,
        {line({{0, 0}, {10, 0}}, 1), line({{0, 5}, {10, 5}}, 9), line({{0, 9}, {10, 9}}, 5), line({{0, 12}, {10, 12}}, 2)},
        {},
        {}};
    const auto classes = [&](std::string_view steps) {
        std::string text;
        for (const Stroke& stroke : drawn(steps, drawing).strokes)
            text += stroke.line == LineClass::thin ? 't' : stroke.line == LineClass::normal ? 'n' : 'T';
        return text;
    };
    EXPECT_EQ(classes("thicken"), "TTTT");
    EXPECT_EQ(classes("thicken line=thin"), "tttt");
    EXPECT_EQ(classes("thicken share=50"), "nTTn");
    EXPECT_EQ(classes("thicken share=25"), "nTnn");
    EXPECT_EQ(classes("thicken share=0"), "nnnn");
    EXPECT_EQ(classes("thicken line=thin\nthicken share=50\nthicken line=normal share=25"), "tnTt");
}

}  // namespace
}  // namespace tactics::strokes_test
