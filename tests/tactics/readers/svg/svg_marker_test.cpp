// SPDX-License-Identifier: Apache-2.0
// Markers: they stand where the line ends and point where it goes, and an arrow head is known for one.
#include "tactics/readers/svg/svg_marker.h"

#include <gtest/gtest.h>

#include "tactics/readers/svg/svg.h"
#include "tests/rules/pages.h"

namespace tactics::svg_marker_test {
namespace {

// In mm; `marker` is what is in it, `line` what it is at.
Page read(const std::string& attributes, const std::string& marker, const std::string& line) {
    return read_svg(
               "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='100mm' viewBox='0 0 200 100'><defs><marker "
               "id='m' " +
                   attributes + ">" + marker + "</marker></defs>" + line + "</svg>",
               "page.svg", 10, std::nullopt)
        .page;
}

constexpr const char* kOpen = "<path d='M0 0L10 5L0 10' fill='none' stroke='black' stroke-linecap='round'/>";
constexpr const char* kHead = "viewBox='0 0 10 10' refX='10' refY='5' markerWidth='4' markerHeight='4' orient='auto'";

void expect_at(Point p, double x, double y) {
    EXPECT_NEAR(p.x, x, 1e-9);
    EXPECT_NEAR(p.y, y, 1e-9);
}

TEST(SvgMarker, StandsAtTheEndAndPointsAhead) {
    // Four line widths long and wide, the tip at the end of the line.
    Page page =
        read(kHead, kOpen,
             "<path d='M10 50h40' fill='none' stroke='black' stroke-width='2' stroke-linecap='round' marker-end='url(#m)'/>");
    ASSERT_EQ(page.strokes.size(), 2u);
    EXPECT_EQ(page.strokes[0].role, Role::arrow);
    EXPECT_EQ(page.strokes[1].role, Role::line);
    expect_at(page.strokes[0].points.at(0), 42, 46);
    expect_at(page.strokes[0].points.at(1), 50, 50);
    expect_at(page.strokes[0].points.at(2), 42, 54);
    // Downwards it points down; in user units the line's width does not count.
    page = read(
        std::string(kHead) + " markerUnits='userSpaceOnUse'", kOpen,
        "<path d='M30 10v40' fill='none' stroke='black' stroke-width='2' stroke-linecap='round' style='marker-end:url(#m)'/>");
    expect_at(page.strokes[0].points.at(0), 32, 46);
    expect_at(page.strokes[0].points.at(1), 30, 50);
    // At the beginning it points along the line, or away from it.
    const std::string start =
        "<path d='M10 50h40' fill='none' stroke='black' stroke-width='1' stroke-linecap='round' marker-start='url(#m)'/>";
    expect_at(read(kHead, kOpen, start).strokes[0].points.at(0), 6, 48);
    std::string reverse = kHead;
    reverse.replace(reverse.find("auto"), 4, "auto-start-reverse");
    expect_at(read(reverse, kOpen, start).strokes[0].points.at(0), 14, 52);
}

TEST(SvgMarker, IsAHeadOrASymbol) {
    const std::string line = "<path d='M10 50h40' fill='none' stroke='black' stroke-width='1' marker-end='url(\"#m\")'/>";
    EXPECT_EQ(read(kHead, "<path d='M0 0L10 5L0 10z'/>", line).areas.at(0).role, Role::arrow);
    EXPECT_EQ(read(kHead, "<circle cx='5' cy='5' r='5'/>", line).areas.at(0).role, Role::symbol);
    EXPECT_TRUE(tests::findings_of(read(kHead, kOpen, line), "filled-arrows").places.empty());
    EXPECT_EQ(tests::findings_of(read(kHead, "<path d='M0 0L10 5L0 10z'/>", line), "filled-arrows").places.size(), 1u);
    // An open head that touches what it points to.
    const std::string target = "<path d='M51 20v60' stroke='black' stroke-width='1'/>";
    EXPECT_EQ(tests::findings_of(read(kHead, kOpen, line + target), "arrow-gap").places.size(), 1u);
}

TEST(SvgMarker, RectanglesHaveNone) {
    EXPECT_EQ(read(kHead, kOpen, "<rect x='9' y='9' width='9' height='9' fill='none' stroke='black' marker-end='url(#m)'/>")
                  .strokes.size(),
              1u);
    EXPECT_EQ(
        read(kHead, kOpen, "<polyline points='9,9 20,9 20,30' fill='none' stroke='black' marker-end='url(#m)'/>").strokes.size(),
        2u);
}

TEST(SvgMarker, ComesToAnEnd) {
    // One that has itself at its end.
    const Page page = read(kHead, "<path d='M0 0L10 5' stroke='black' marker-end='url(#m)'/>",
                           "<path d='M10 50h40' fill='none' stroke='black' stroke-width='1' marker-end='url(#m)'/>");
    EXPECT_EQ(page.strokes.size(), 2u);
    for (const std::string url : {"", "none", "url()", "url(#", "#m", "url(#other)", "url(x)"})
        EXPECT_EQ(read(kHead, kOpen, "<path d='M10 50h40' stroke='black' marker-end='" + url + "'/>").strokes.size(), 1u) << url;
}

}  // namespace
}  // namespace tactics::svg_marker_test
