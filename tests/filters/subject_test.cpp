// SPDX-License-Identifier: Apache-2.0
// The thing that a person points at or draws a box around, in pictures where it is known.
#include "filters/subject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/arc_worth.h"
#include "filters/list.h"
#include "tactics/recipe.h"
#include "tests/filters/pictures.h"

namespace tactics::subject_test {
namespace {

constexpr int kWide = 240, kHigh = 180;
constexpr double kPixel = 0.5;  // mm
constexpr Point kFirst{80, 90}, kSecond{185, 90};
constexpr double kRadius = 40;

bool in_disc(int x, int y, Point middle, double radius) { return std::hypot(x + 0.5 - middle.x, y + 0.5 - middle.y) < radius; }

// Discs of one grey on stripes, dark and light.
Image on_stripes(bool two) {
    Image image = make_image(kWide, kHigh, 1, kPixel, 0);
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x) {
            const bool disc = in_disc(x, y, kFirst, kRadius) || (two && in_disc(x, y, kSecond, kRadius));
            image.row(y)[x] = static_cast<std::uint8_t>(disc ? 20 : y / 20 % 2 == 0 ? 190 : 240);
        }
    return image;
}

RegionTree tree_of(const Image& image) {
    const Step step = parse_step("nest map=plain", "test", filters());
    return std::get<RegionTree>(step.filter->apply(image, step.settings));
}

Drawing drawn(const RegionTree& tree, const std::string& settings) {
    const Step step = parse_step("outlines " + settings, "test", filters());
    return std::get<Drawing>(step.filter->apply(tree, step.settings));
}

Drawing drawn(const Image& image, const std::string& settings) { return drawn(tree_of(image), settings); }

bool same(const Drawing& a, const Drawing& b) {
    return std::equal(a.strokes.begin(), a.strokes.end(), b.strokes.begin(), b.strokes.end(),
                      [](const Stroke& p, const Stroke& q) {
                          return p.closed == q.closed && p.line == q.line &&
                                 std::equal(p.points.begin(), p.points.end(), q.points.begin(), q.points.end(),
                                            [](const Point& m, const Point& n) { return m.x == n.x && m.y == n.y; });
                      });
}

// Points of lines right of that share of the width.
std::size_t points_right_of(const Drawing& drawing, double share) {
    std::size_t count = 0;
    for (const Stroke& stroke : drawing.strokes)
        for (const Point& p : stroke.points) count += p.x >= share * drawing.width ? 1 : 0;
    return count;
}

Spot spot_of(const std::string& text) { return parse_spots(text, "test", "it").at(0); }

double overlap(const RegionTree& tree, const std::string& spot, Point middle) {
    const std::vector<bool> faces = faces_of_subject(tree, arc_chances_of(tree).drawn, spot_of(spot));
    const double grown = static_cast<double>(tree.width) / kWide;
    middle = {middle.x * grown, middle.y * grown};
    double both = 0, either = 0;
    for (int y = 0; y < tree.height; ++y)
        for (int x = 0; x < tree.width; ++x) {
            const bool found = faces[tree.face[static_cast<std::size_t>(y * tree.width + x)]],
                       disc = in_disc(x, y, middle, kRadius * grown);
            both += found && disc ? 1 : 0;
            either += found || disc ? 1 : 0;
        }
    return both / either;
}

double length_of(const Drawing& drawing, LineClass line) {
    double length = 0;
    for (const Stroke& stroke : drawing.strokes)
        for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < stroke.points.size() && stroke.line == line; ++i)
            length += distance(stroke.points[i], stroke.points[(i + 1) % stroke.points.size()]);
    return length;
}

TEST(Subject, ABoxAroundADiscOnStripesGivesTheDisc) {
    const RegionTree tree = tree_of(on_stripes(false));
    EXPECT_GT(overlap(tree, "16%,27%-51%,73%", kFirst), 0.9);
    EXPECT_GT(overlap(tree, "10%,20%-57%,82%", kFirst), 0.9) << "a box drawn less closely";
}

TEST(Subject, APointInItGivesTheDisc) {
    const RegionTree tree = tree_of(on_stripes(false));
    EXPECT_GT(overlap(tree, "33%,50%", kFirst), 0.9);
    EXPECT_GT(overlap(tree, "28%,42%", kFirst), 0.9) << "off its middle";
}

TEST(Subject, WhereNothingIsNothingIsFound) {
    const Image blank = make_image(kWide, kHigh, 1, kPixel, 200);
    const RegionTree tree = tree_of(blank);
    for (const std::string spot : {"20%,20%-60%,70%", "50%,50%", "0%,0%", "100%,100%", "0%,0%-100%,100%"}) {
        const auto faces = faces_of_subject(tree, arc_chances_of(tree).drawn, spot_of(spot));
        EXPECT_EQ(std::count(faces.begin(), faces.end(), true), 0) << spot;
    }
}

TEST(Subject, ItsOutlineIsThickAndWholeAndTheRestIsThin) {
    const Drawing drawing = drawn(on_stripes(true), "subject=16%,27%-51%,73%");
    const double round = 2 * 3.14159 * kRadius * kPixel;
    EXPECT_NEAR(length_of(drawing, LineClass::thick), round, 0.1 * round);
    EXPECT_LE(length_of(drawing, LineClass::normal), 0.6 * round);
    for (const Stroke& stroke : drawing.strokes)
        for (const Point& p : stroke.points)
            if (stroke.line == LineClass::thick) {
                EXPECT_NEAR(distance(p, {kFirst.x * kPixel, kFirst.y * kPixel}), kRadius * kPixel, 2);
            }
}

TEST(Subject, SeveralHintsAreSeveralThings) {
    const Drawing drawing = drawn(on_stripes(true), "subject=16%,27%-51%,73%;77%,50% only=yes");
    const double round = 2 * 3.14159 * kRadius * kPixel;
    EXPECT_NEAR(length_of(drawing, LineClass::thick), 2 * round, 0.2 * round);
    EXPECT_EQ(length_of(drawing, LineClass::thin), 0);
    EXPECT_EQ(std::count_if(drawing.strokes.begin(), drawing.strokes.end(), [](const Stroke& s) { return s.closed; }), 2);
}

TEST(Subject, AloneItIsClosedAlongTheFrame) {
    Image image = make_image(kWide, kHigh, 1, kPixel, 230);
    for (int y = 60; y < 120; ++y) std::fill_n(image.row(y), 100, std::uint8_t{20});  // at the left edge
    const Drawing drawing = drawn(image, "subject=0%,30%-45%,70% only=yes");
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_TRUE(drawing.strokes[0].closed);
    EXPECT_TRUE(std::any_of(drawing.strokes[0].points.begin(), drawing.strokes[0].points.end(),
                            [](const Point& p) { return p.x < 0.5 && p.y > 40 && p.y < 50; }));
    EXPECT_EQ(drawing.width, kWide * kPixel);
}

TEST(Subject, AloneItIsClosedAlongBars) {
    Image image = make_image(kWide, kHigh, 1, kPixel, 0);
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x) {
            const bool bar = x < 60 || x >= kWide - 30;  // the disc is cut off by the left one
            image.row(y)[x] = bar ? 120 : in_disc(x, y, kFirst, kRadius) ? 20 : (x + y) / 20 % 2 == 0 ? 190 : 240;
        }
    ASSERT_GT(tree_of(image).inside.left, 0);
    const Drawing drawing = drawn(image, "subject=22%,27%-51%,73% only=yes");
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_TRUE(drawing.strokes[0].closed);
    const auto [left, right] = std::minmax_element(drawing.strokes[0].points.begin(), drawing.strokes[0].points.end(),
                                                   [](const Point& a, const Point& b) { return a.x < b.x; });
    EXPECT_NEAR(left->x, 60 * kPixel, 1.5);  // pixels where a bar ends are no part of the scene
    EXPECT_NEAR(right->x, (kFirst.x + kRadius) * kPixel, 1.5);
}

TEST(Subject, InWhatIsLeftOutOnlyTheSubjectIsDrawn) {
    const Image image = on_stripes(true);
    const auto in_box = [](const Drawing& drawing) { return points_right_of(drawing, 0.6); };
    ASSERT_GT(in_box(drawn(image, "")), 0u);
    EXPECT_EQ(in_box(drawn(image, "leave=60%,0%-100%,100%")), 0u);
    EXPECT_EQ(in_box(drawn(image, "leave=60%,0%-100%,100% subject=16%,27%-51%,73%")), 0u);
    EXPECT_GT(in_box(drawn(image, "leave=60%,0%-100%,100% subject=77%,50%")), 0u);
}

TEST(Subject, WhatIsLeftOutHasNoThinLineEither) {
    RegionTree tree = tree_of(on_stripes(false));
    const double grown = static_cast<double>(tree.width) / kWide;
    RegionLine mast{{}, 255, {0, 0}};  // from the disc to the right
    for (double x = kFirst.x * grown; x < 0.95 * tree.width; ++x) mast.points.push_back({x, (kFirst.y + 10) * grown});
    tree.lines = {mast};
    ASSERT_GT(points_right_of(drawn(tree, ""), 0.8), 0u);
    const Drawing cut = drawn(tree, "leave=80%,0%-100%,100%");
    EXPECT_EQ(points_right_of(cut, 0.8), 0u) << "its end is in the box, its beginning is not";
    EXPECT_GT(points_right_of(cut, 0.6), 0u);
    EXPECT_GT(length_of(drawn(tree, "subject=16%,27%-51%,73% only=yes gap=0.1mm"), LineClass::thin), 0)
        << "it begins at the disc, and no room is asked for";
}

TEST(Subject, WhatIsLeftOutHasNoInnerLineEither) {
    Image image = make_image(kWide, kHigh, 1, kPixel, 230);
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x) {
            if (std::hypot((x - 120) / 1.2, y - 90) < 75) image.row(y)[x] = 140;
            if ((y > 60 && y < 67) && ((x > 60 && x < 95) || (x > 145 && x < 180))) image.row(y)[x] = 40;
        }
    const std::string settings = "inner=0.6 gap=1.5mm";
    const auto inner = [&](const std::string& more, bool right) {
        std::size_t count = 0;
        for (const Stroke& stroke : drawn(image, settings + more).strokes)
            for (const Point& p : stroke.points) {
                const bool eye = p.y > 25 && p.y < 40 && (right ? p.x > 70 && p.x < 95 : p.x > 25 && p.x < 50);
                count += eye && std::hypot((p.x - 60) / 1.2, p.y - 45) < 33 ? 1 : 0;
            }
        return count;
    };
    ASSERT_GT(inner("", true), 0u);
    ASSERT_GT(inner("", false), 0u);
    EXPECT_EQ(inner(" leave=55%,25%-85%,50%", true), 0u);
    EXPECT_GT(inner(" leave=55%,25%-85%,50%", false), 0u);
}

TEST(Subject, ABoxOnNothingAndAPlaceInVainChangeNothing) {
    const Image image = on_stripes(true);
    const Drawing page = drawn(image, "");
    ASSERT_FALSE(page.strokes.empty());
    EXPECT_TRUE(same(drawn(image, "subject=0%,0%-100%,100%"), page));
    EXPECT_TRUE(same(drawn(image, "subject=0%,0%-100%,100% only=yes"), page));
    EXPECT_TRUE(same(drawn(image, "leave=53%,40%-54%,41%"), page)) << "between the discs";
    EXPECT_FALSE(same(drawn(image, "subject=77%,50%"), page));
}

TEST(Subject, MoreLineIsMoreBesideAHintToo) {
    const Image leaves = pictures::leaves();
    for (const std::string hint : {"", " leave=0%,0%-8%,8%", " subject=30%,30%-70%,70%"}) {
        const double usual = total_stroke_length(drawn(leaves, "line=140mm" + hint)),
                     twice = total_stroke_length(drawn(leaves, "line=280mm" + hint));
        EXPECT_GT(twice, 1.4 * usual) << hint;
    }
}

TEST(Subject, WhatIsFoundIsTold) {
    const auto told = [](const Image& image, const std::string& settings) {
        Step step = parse_step("outlines " + settings, "test", filters());
        const ChosenSetting said = step.filter->settle(tree_of(image), step.settings);
        EXPECT_FALSE(said.can_be_changed());
        return said.why.english();
    };
    EXPECT_EQ(told(on_stripes(false), ""), "");
    const std::string found = told(on_stripes(false), "subject=16%,27%-51%,73%");
    EXPECT_TRUE(found == "found, 12 % of the picture" || found == "found, 11 % of the picture") << found;
    EXPECT_EQ(told(on_stripes(false), "subject=0%,0%-100%,100%"),
              "0%,0%-100%,100% is all of the picture and names nothing in it: draw the box closely around the thing");
    const std::string both = told(on_stripes(false), "subject=16%,27%-51%,73%;33%,50%");
    EXPECT_TRUE(both.starts_with("what was found at 16%,27%-51%,73% is part of what a later place names; found, 1")) << both;
    const Image blank = make_image(kWide, kHigh, 1, kPixel, 200);
    EXPECT_EQ(told(blank, "subject=40%,50%"), "no closed thing was found at 40%,50%: draw a box around it");
    EXPECT_EQ(told(blank, "subject=40%,50%;10%,10%-30%,30%"),
              "no closed thing was found at 40%,50%: draw a box around it; no closed thing was found in "
              "10%,10%-30%,30%: draw the box closely around all of it");
}

}  // namespace
}  // namespace tactics::subject_test
