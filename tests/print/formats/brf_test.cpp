// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "print/format.h"
#include "tactics/braille/braille.h"
#include "tests/print/brf_reader.h"

namespace tactics::brf_test {
namespace {

using test::BrfDot;
using test::BrfPage;

constexpr double kPi = std::numbers::pi;

Page braille_paper() {
    Page page;
    page.width = 279.4;
    page.height = 292.1;
    page.live = {6, 6, 44 * 6 + 2.5, 27 * 10 + 5};  // 45 x 28 cells; 0.9 x 5.1 mm less than margins of 6 mm leave
    page.braille_dot = 1.6;
    return page;
}

BrfPage embossed(const Page& page) {
    const Format* format = find_format("brf");
    const std::string text = format->encode(page, Settings(format->options));
    const auto pages = test::read_brf(text);
    EXPECT_EQ(pages.size(), 1u);
    for (const std::string& line : pages.at(0).lines) EXPECT_TRUE(line.empty() || line.back() != ' ');
    EXPECT_TRUE(pages[0].lines.empty() || !pages[0].lines.back().empty());
    return pages[0];
}

double distance(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// Judged in mm on the paper. Dots of a 6-dot page are at most 3.5 mm apart across and 5 mm down, so the nearest to a
// point lies within half of that in each direction; 0.15 of it is the waver that dot_chain allows.
void expect_on_paper(const Page& page) {
    const BrfPage paper = embossed(page);
    ASSERT_FALSE(paper.dots.empty());
    const double half = std::hypot(3.5 * 0.65, 5.0 * 0.65), pitch = std::hypot(3.5, 5.0);
    for (const BrfDot& dot : paper.dots) {
        double nearest = 1e9;
        for (const PageStroke& stroke : page.strokes)
            for (std::size_t i = 0; i + 1 < stroke.points.size() + (stroke.closed ? 1 : 0); ++i)
                nearest = std::min(
                    nearest, distance({dot.x + 6, dot.y + 6}, stroke.points[i], stroke.points[(i + 1) % stroke.points.size()]));
        EXPECT_LE(nearest, half);
    }
    for (const PageStroke& stroke : page.strokes)
        for (const Point& point : stroke.points) {
            double nearest = 1e9;
            for (const BrfDot& dot : paper.dots)
                nearest = std::min(nearest, std::hypot(dot.x + 6 - point.x, dot.y + 6 - point.y));
            EXPECT_LE(nearest, pitch);
        }
}

TEST(Brf, CircleStarAndSpiralStandWhereTheyAreDrawn) {
    Page circle = braille_paper(), star = circle, spiral = circle;
    PageStroke ring{{}, true, 1.6}, rays{{}, true, 1.6}, turns{{}, false, 1.6};
    for (int i = 0; i < 300; ++i) ring.points.push_back({140 + 90 * std::cos(i * kPi / 150), 150 + 90 * std::sin(i * kPi / 150)});
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 100 : 40;
        rays.points.push_back({140 + radius * std::sin(i * kPi / 5), 150 - radius * std::cos(i * kPi / 5)});
    }
    for (double a = 1; a < 14 * kPi; a += 0.02)
        turns.points.push_back({140 + 2.4 * a * std::cos(a), 150 + 2.4 * a * std::sin(a)});
    circle.strokes = {ring};
    star.strokes = {rays};
    spiral.strokes = {turns};
    expect_on_paper(circle);
    expect_on_paper(star);
    expect_on_paper(spiral);
}

TEST(Brf, NothingIsDistorted) {
    // A square and a circle in mm stay so: as wide as they are high, to within a dot on each side.
    Page page = braille_paper();
    page.strokes = {{{{50, 60}, {200, 60}, {200, 210}, {50, 210}}, true, 1.6}};
    const BrfPage paper = embossed(page);
    double left = 1e9, right = 0, top = 1e9, bottom = 0;
    for (const BrfDot& dot : paper.dots) {
        left = std::min(left, dot.x), right = std::max(right, dot.x);
        top = std::min(top, dot.y), bottom = std::max(bottom, dot.y);
    }
    EXPECT_NEAR(left + 6, 50, 3.5 * 0.65);
    EXPECT_NEAR(right + 6, 200, 3.5 * 0.65);
    EXPECT_NEAR(top + 6, 60, 5 * 0.65);
    EXPECT_NEAR(bottom + 6, 210, 5 * 0.65);
}

TEST(Brf, TitleIsTextOnTheCellGrid) {
    Page page = braille_paper();
    page.braille.push_back({{6, 6}, to_braille("Hot air balloon", "en-ueb-g1.ctb")});
    page.braille.push_back({{6 + 12, 6 + 10}, to_braille("map 2", "en-ueb-g1.ctb")});
    page.strokes = {{{{20, 40}, {200, 40}}, false, 1.6}};
    const BrfPage paper = embossed(page);
    ASSERT_GE(paper.lines.size(), 3u);
    EXPECT_EQ(paper.lines[0], ",HOT AIR BALLOON");
    EXPECT_EQ(paper.lines[1], "  MAP #B");
    // The dots of the letters are those that other formats draw.
    std::set<std::pair<long, long>> drawn, read;
    for (const BrailleLine& line : page.braille)
        for (const Point& dot : dots_of(line, page.cell))
            drawn.insert({std::lround((dot.x - 6) * 10), std::lround((dot.y - 6) * 10)});
    for (const BrfDot& dot : paper.dots)
        if (dot.y < 20) read.insert({std::lround(dot.x * 10), std::lround(dot.y * 10)});
    EXPECT_EQ(drawn, read);
}

TEST(Brf, LettersWinOverTheDrawing) {
    Page page = braille_paper();
    page.braille.push_back({{6, 6}, to_braille("abc", "en-ueb-g1.ctb")});
    page.strokes = {{{{6, 8.5}, {58, 8.5}}, false, 1.6}};
    EXPECT_EQ(embossed(page).lines.at(0), "ABC333333");
}

TEST(Brf, EmptyPageIsAFormFeed) {
    const Format* format = find_format("brf");
    EXPECT_EQ(format->encode(braille_paper(), Settings(format->options)), "\f");
}

TEST(Brf, PageHoldsWhatFits) {
    Page page = braille_paper();
    page.live = {6, 6, 267.4, 280.1};
    page.areas.push_back({{{{0, 0}, {279.4, 0}, {279.4, 292.1}, {0, 292.1}}}});
    const BrfPage paper = embossed(page);
    EXPECT_EQ(paper.lines.size(), 28u);
    for (const std::string& line : paper.lines) EXPECT_EQ(line, std::string(45, '='));
}

TEST(Brf, OddTitlesStayOnThePage) {
    Page page = braille_paper();
    page.braille.push_back({{-30, 6}, to_braille("far to the left", "en-ueb-g1.ctb")});
    page.braille.push_back({{6, -40}, to_braille("above", "en-ueb-g1.ctb")});
    page.braille.push_back({{6, 1e6}, to_braille("below", "en-ueb-g1.ctb")});
    page.braille.push_back({{6, 26}, std::vector<std::uint8_t>(500, 0xFF)});
    const BrfPage paper = embossed(page);
    ASSERT_EQ(paper.lines.size(), 3u);
    EXPECT_EQ(paper.lines[2], std::string(45, '='));
}

}  // namespace
}  // namespace tactics::brf_test
