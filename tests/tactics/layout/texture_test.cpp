// SPDX-License-Identifier: Apache-2.0
// Textures on pages: where their marks stand, what they keep away from, how much they blacken.
#include "tactics/layout/texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "print/dots.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/layout/dot_grid.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/pattern.h"
#include "tactics/rules/coverage.h"
#include "tests/rules/pages.h"

namespace tactics::texture_test {
namespace {

using namespace tests;

constexpr int kTextures = 5;

const Medium& medium(std::string_view name) { return find_medium(name, "test"); }

std::vector<PageStroke> marks_of(const Page& page) {
    std::vector<PageStroke> marks;
    for (const PageStroke& stroke : page.strokes)
        if (stroke.role == Role::pattern) marks.push_back(stroke);
    return marks;
}

bool holds(const Area& area, Point p) {
    bool inside = false;
    for (const auto& ring : area.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
        }
    return inside;
}

double apart(const PageStroke& one, const std::vector<Point>& points, bool closed) {
    double least = 1e9;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
        least = std::min(least, nearest({one.points[0], one.points[1]}, {points[i], points[(i + 1) % points.size()]}).distance);
    return least;
}

std::vector<std::string> broken(const Page& page, const Medium& on, bool only_hard) {
    std::vector<std::string> all;
    for (const Verdict& verdict : check_page(page, demands_of(on)))
        if (verdict.demand.rule->hard || !only_hard)
            for (const Finding& finding : verdict.findings.places)
                all.push_back(std::string(verdict.demand.rule->name) + ": " + finding.message.english());
    return all;
}

TEST(Texture, TheListIsWhatItSays) {
    std::vector<std::string_view> names;
    for (const Texture& texture : textures()) {
        names.push_back(texture.name.text);
        EXPECT_LT(share_black(static_cast<int>(names.size())), 0.26) << texture.name.text;
        // More than a fingertip tells, less than parts two things, but for dots that are meant to be felt one by one.
        EXPECT_GT(texture.between_rows, 1.0) << texture.name.text;
        const std::size_t width = texture.tile.find('/');
        for (std::size_t row = 0; width != std::string_view::npos && row + width <= texture.tile.size(); row += width + 1)
            EXPECT_TRUE(row + width == texture.tile.size() || texture.tile[row + width] == '/') << texture.name.text;
        EXPECT_EQ(texture.tile.find_first_not_of("#./"), std::string_view::npos);
    }
    EXPECT_EQ(names,
              (std::vector<std::string_view>{"coarse dots", "level lines", "upright lines", "slanting dashes", "fine dots"}));
    EXPECT_EQ(name_of_texture(2).english(), "level lines");
    EXPECT_EQ(name_of_texture(0).english(), "a texture");
    EXPECT_EQ(name_of_texture(9).english(), "a texture");
}

TEST(Texture, BlankDiffersMostAndNoneFromItself) {
    double most = 0;
    for (int a = 0; a <= kTextures; ++a)
        for (int b = 0; b <= kTextures; ++b) {
            EXPECT_DOUBLE_EQ(difference(a, b), difference(b, a));
            EXPECT_EQ(difference(a, b) == 0, a == b) << a << " " << b;
            if (a > 0 && b > 0) most = std::max(most, difference(a, b));
        }
    for (int a = 1; a <= kTextures; ++a) EXPECT_GT(difference(0, a), most);
    // Dots and dots are nearer than dots and lines; lines that cross are further than lines and slanting dashes.
    EXPECT_LT(difference(1, 5), difference(1, 2));
    EXPECT_LT(difference(2, 4), difference(2, 3));
}

// Random areas with holes, lines, black and braille on them: each mark is inside one and keeps its distance from all.
TEST(Texture, MarksKeepTheirDistance) {
    Dice chance(11);
    for (const std::string name : {"swell", "thermoform", "embosser"}) {
        const Medium& on = medium(name);
        for (int round = 0; round < 12; ++round) {
            Page page = blank_page();
            const int texture = 1 + round % kTextures;
            Area area{{starry_ring(chance, {100, 100}, 60, 95), starry_ring(chance, {100, 100}, 8, 15)}, Role::line, texture};
            page.textured.push_back(area);
            add_line(page, wandering_line(chance, {70, 70}, 12, 20), on.line);
            page.areas.push_back({{starry_ring(chance, {140, 120}, 3, 10)}});
            page.braille.push_back({{60, 130}, {1, 0, 0x3f}});
            const PageStroke line = page.strokes[0];
            draw_patterns(page, on);
            const auto marks = marks_of(page);
            ASSERT_GT(marks.size(), 20u) << name << " round " << round;
            for (const PageStroke& mark : marks) {
                for (const double t : {0.0, 0.3, 0.7, 1.0}) {
                    const Point a = mark.points[0], b = mark.points[1];
                    EXPECT_TRUE(holds(area, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
                }
                const double half = mark.width / 2, two_rows = name == "embosser" ? 5 : 0;
                EXPECT_GE(apart(mark, line.points, false), std::max(on.gap + half + on.line / 2, two_rows));
                EXPECT_GE(apart(mark, page.areas[0].rings[0], true), std::max(on.gap + half, two_rows));
                EXPECT_FALSE(holds(page.areas[0], mark.points[0]));
                for (const auto& ring : area.rings) EXPECT_GE(apart(mark, ring, true), on.gap / 2 + half - 1e-9);
                const Box braille{60 - 0.8, 130 - 0.8, 60 + 12 + 2.5 + 0.8, 130 + 5 + 0.8};
                EXPECT_GE(nearest({mark.points[0], mark.points[1]}, braille).distance, 3.2 + half);
            }
            EXPECT_TRUE(findings_of(page, "texture-clearance", on.gap).places.empty()) << name << " round " << round;
        }
    }
}

// As much of the pattern as fits: a pattern over the whole page without its marks near the border is the pattern of the area.
TEST(Texture, NothingThatFitsIsLeftOut) {
    for (int texture = 1; texture <= kTextures; ++texture)
        for (const std::string name : {"swell", "embosser"}) {
            const Medium& on = medium(name);
            Page whole = blank_page(), part = blank_page();
            whole.textured.push_back({{rectangle(0, 0, 200, 200)}, Role::line, texture});
            part.textured.push_back({{rectangle(30, 40, 100, 90)}, Role::line, texture});
            draw_patterns(whole, on);
            draw_patterns(part, on);
            const auto dots = [&](const Page& page, double inset) {
                std::size_t count = 0;
                for (const PageStroke& mark : marks_of(page)) {
                    bool inside = true;
                    for (const Point& p : mark.points)
                        inside = inside && p.x > 30 + inset && p.x < 130 - inset && p.y > 40 + inset && p.y < 130 - inset;
                    count += inside ? 1 : 0;
                }
                return count;
            };
            const double off = name == "embosser" ? 3.4 : 1.7 + on.line;
            if (textures()[static_cast<std::size_t>(texture - 1)].endless() && name == "swell") {
                double length = 0;
                for (const PageStroke& mark : marks_of(part)) {
                    EXPECT_NEAR(distance(mark.points[0], mark.points[1]), (texture == 2 ? 100 : 90), 4.6);
                    length += distance(mark.points[0], mark.points[1]);
                }
                EXPECT_NEAR(length, 100 * 90 / (texture == 2 ? 2.8 : 5.0), 500);
            } else {
                EXPECT_GE(marks_of(part).size(), dots(whole, off)) << texture << " " << name;
                EXPECT_GT(dots(whole, off), 20u);
            }
        }
}

TEST(Texture, InkStaysUnderTheLimitHoweverMuchIsTextured) {
    for (int texture = 1; texture <= kTextures; ++texture) {
        Page page = blank_page();
        page.textured.push_back({{rectangle(0, 0, 200, 200)}, Role::line, texture});
        draw_patterns(page, medium("swell"));
        const PageGeometry geometry(page);
        const double percent = percent_black(geometry).value();
        EXPECT_LT(percent, 26) << texture;
        EXPECT_NEAR(percent, 100 * share_black(texture), 2) << texture;
    }
}

// No moire: what an embosser raises are the marks themselves, dot for dot.
TEST(Texture, FixedDotsAreThePatternsOwn) {
    for (int texture = 1; texture <= kTextures; ++texture) {
        Page page = blank_page();
        page.live = {7.3, 8.1, 180, 170};
        page.textured.push_back({{circle({100, 100}, 60)}, Role::line, texture});
        draw_patterns(page, medium("embosser"));
        const DotGrid grid = cell_grid(page.live, page.cell);
        const auto marks = marks_of(page);
        ASSERT_GT(marks.size(), 50u) << texture;
        const Dots dots = raise_dots(page, grid);
        EXPECT_EQ(static_cast<std::size_t>(std::count(dots.raised.begin(), dots.raised.end(), 1)), marks.size()) << texture;
        for (const PageStroke& mark : marks) {
            EXPECT_TRUE(std::binary_search(grid.columns.begin(), grid.columns.end(), mark.points[0].x));
            EXPECT_TRUE(std::binary_search(grid.rows.begin(), grid.rows.end(), mark.points[0].y));
        }
    }
}

// A scene as recipes make it, on every medium: no texture breaks a hard rule.
TEST(Texture, APageOfAllTexturesKeepsTheRules) {
    Drawing drawing{180, 240, {}, {}, {}};
    for (int i = 0; i < kTextures + 1; ++i) {
        const auto ring = rectangle(5 + i % 2 * 90.0, 5 + i / 2 * 80.0, 75, 60);
        drawing.strokes.push_back({ring, true, LineClass::normal, 0});
        drawing.areas.push_back({{ring}, Role::line, i});
    }
    drawing.areas[0].rings = {circle({42, 35}, 10, 60)};  // black
    for (const Medium& on : media()) {
        Sheet sheet;
        sheet.paper = find_paper("a4", "test");
        sheet.medium = &on;
        sheet.title = "Textures";
        drawing.names = {{{130, 110}, "pond", "test"}};
        const Page page = lay_out(drawing, sheet);
        EXPECT_EQ(page.textured.size(), 5u);
        EXPECT_EQ(page.areas.size(), 1u);
        EXPECT_EQ(page.names.size(), 1u);
        const bool own_words = holds(page.textured[2], page.names[0].place.middle()) || !page.names[0].key.empty();
        EXPECT_TRUE(own_words || on.name != "swell") << "the name has room within the area";
        const auto faults = broken(page, on, on.name == "embosser");  // the side of a braille cell is not this test's
        EXPECT_TRUE(faults.empty()) << on.name << ": " << faults[0];
        EXPECT_NEAR(total_stroke_length(page), 6 * 270 * (page.strokes[0].points[1].x - page.strokes[0].points[0].x) / 75, 150);
    }
}

TEST(Texture, MarksAreBoundedOnAWall) {
    Page page = blank_page(5000, 5000);
    page.textured.push_back({{rectangle(0, 0, 5000, 5000)}, Role::line, 5});
    draw_patterns(page, medium("swell"));
    EXPECT_LE(page.strokes.size(), 520'000u);
    EXPECT_GE(page.strokes.size(), 400'000u);
    page.strokes.clear();
    EXPECT_THROW(draw_patterns(page, medium("embosser")), Error);
}

TEST(Texture, AreasOfNothingHaveNoMarks) {
    for (const std::string name : {"swell", "embosser"}) {
        Page page = blank_page();
        page.textured.push_back({{}, Role::line, 1});
        page.textured.push_back({{{}, {{5, 5}}, {{5, 5}, {9, 9}}}, Role::line, 2});
        page.textured.push_back({{rectangle(50, 50, 2, 100)}, Role::line, 3});   // too narrow
        page.textured.push_back({{rectangle(50, 50, 50, 50)}, Role::line, 77});  // no texture
        draw_patterns(page, medium(name));
        EXPECT_TRUE(page.strokes.empty()) << name;
    }
}

}  // namespace
}  // namespace tactics::texture_test
