// Dashed lines as they are cut when all else is mended.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/page.h"
#include "tactics/repair/repair.h"
#include "tactics/rules/rule.h"

namespace tactics {
namespace {

Drawing blank() {
    Drawing drawing;
    drawing.width = 180;
    drawing.height = 250;
    return drawing;
}

Stroke dashed(std::vector<Point> points, bool closed = false) {
    return {std::move(points), closed, LineClass::normal, 0, Role::dash};
}

std::size_t dashes_of(const Drawing& drawing) {
    return static_cast<std::size_t>(std::count_if(drawing.strokes.begin(), drawing.strokes.end(),
                                                  [](const Stroke& stroke) { return stroke.role == Role::dash; }));
}

// Places that break any of these rules, as it would be printed.
std::size_t places(const Drawing& drawing, const Medium& medium, std::initializer_list<std::string_view> rules) {
    Sheet sheet;
    sheet.paper = {"", "", drawing.width, drawing.height};
    sheet.medium = &medium;
    sheet.bare = true;
    sheet.margin = 0;
    std::size_t count = 0;
    for (const Verdict& verdict : check_page(lay_out(drawing, sheet), demands_of(medium)))
        for (const std::string_view rule : rules)
            if (verdict.demand.rule->name == rule) count += verdict.findings.places.size();
    return count;
}

TEST(Dashes, AreAsTheRulesHaveThemOnEveryMedium) {
    for (const Medium& medium : media()) {
        Drawing drawing = blank();
        drawing.strokes.push_back(dashed({{10, 20}, {170, 40}}));
        drawing.strokes.push_back(dashed({{10, 60}, {100, 90}, {170, 60}}));
        std::vector<Point> circle;
        for (int i = 0; i < 90; ++i)
            circle.push_back({90 + 40 * std::cos(i * std::numbers::pi / 45), 170 + 40 * std::sin(i * std::numbers::pi / 45)});
        drawing.strokes.push_back(dashed(circle, true));
        const Repaired repaired = repair(drawing, medium);
        EXPECT_GT(dashes_of(repaired.drawing), 40u) << medium.name;
        EXPECT_EQ(places(repaired.drawing, medium, {"dash-length", "long-dashes", "dash-gaps", "gap", "merging-dots"}), 0u)
            << medium.name;
        EXPECT_EQ(repaired.broken_after, 0u);
        EXPECT_DOUBLE_EQ(repaired.kept, 1);
    }
}

TEST(Dashes, RunThroughWhereOthersCross) {
    Drawing drawing = blank();
    drawing.strokes.push_back(dashed({{10, 100}, {170, 100}}));
    for (const double x : {31.0, 77.0, 122.5}) drawing.strokes.push_back({{{x, 20}, {x + 5, 200}}, false});
    const Medium& swell = find_medium("swell", "test");
    const Repaired repaired = repair(drawing, swell);
    EXPECT_EQ(repaired.broken_after, 0u);
    EXPECT_EQ(places(repaired.drawing, swell, {"gap", "dash-length"}), 0u);
    for (const double x : {31.0, 77.0, 122.5}) {
        const double crossing = x + 5 * 80.0 / 180;
        const bool through =
            std::any_of(repaired.drawing.strokes.begin(), repaired.drawing.strokes.end(), [&](const Stroke& stroke) {
                return stroke.role == Role::dash && stroke.points.front().x < crossing - 3 &&
                       stroke.points.back().x > crossing + 3;
            });
        EXPECT_TRUE(through) << x;
    }
}

TEST(Dashes, ShortLinesAndDashesThatAreCutAlreadyStayWhole) {
    Drawing drawing = blank();
    drawing.strokes.push_back(dashed({{10, 20}, {22, 20}}));
    drawing.strokes.push_back(dashed({{10, 60}, {170, 60}}));
    const Medium& swell = find_medium("swell", "test");
    cut_dashes(drawing, swell);
    const std::size_t count = drawing.strokes.size();
    EXPECT_GT(count, 10u);
    EXPECT_DOUBLE_EQ(drawing.strokes[0].points[1].x, 22);
    // From end to end.
    EXPECT_DOUBLE_EQ(drawing.strokes[1].points.front().x, 10);
    EXPECT_NEAR(drawing.strokes.back().points.back().x, 170, 1e-9);
    cut_dashes(drawing, swell);
    EXPECT_EQ(drawing.strokes.size(), count);
}

}  // namespace
}  // namespace tactics
