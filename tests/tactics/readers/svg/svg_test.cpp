// SPDX-License-Identifier: Apache-2.0
// SVG of all kinds as pages: positions in mm, and what is told where it cannot be read.
#include "tactics/readers/svg/svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tactics/error.h"
#include "tactics/geometry/distance.h"
#include "tactics/layout/lay_out.h"
#include "tactics/units.h"
#include "tests/cli/fake_disk.h"
#include "tests/print/hard_pages.h"
#include "tests/print/rendered_page.h"

namespace tactics::svg_test {
namespace {

using tests::error_of;

constexpr std::string_view kHead =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"200mm\" height=\"100mm\" "
    "viewBox=\"0 0 200 100\">";

FoundPage read(const std::string& body, std::string_view head = kHead) {
    return read_svg(std::string(head) + "\n" + body + "</svg>", "page.svg", 10, std::nullopt);
}

// The only stroke of a drawing.
PageStroke stroke_of(const std::string& body) {
    const Page page = read(body).page;
    EXPECT_EQ(page.strokes.size(), 1u) << body;
    return page.strokes.empty() ? PageStroke{} : page.strokes[0];
}

void expect_ends(const PageStroke& stroke, Point from, Point to) {
    ASSERT_GE(stroke.points.size(), 2u);
    EXPECT_NEAR(distance(stroke.points.front(), from), 0, 1e-6);
    EXPECT_NEAR(distance(stroke.points.back(), to), 0, 1e-6);
}

TEST(Svg, KnowsItsSize) {
    const auto size = [](const std::string& attributes, const std::optional<Paper>& paper = std::nullopt) {
        const Page page = read_svg("<svg " + attributes + "/>", "page.svg", 10, paper).page;
        return Point{page.width, page.height};
    };
    EXPECT_NEAR(size("width='210mm' height='297mm'").x, 210, 1e-9);
    EXPECT_NEAR(size("width='8.5in' height='11in'").y, 279.4, 1e-9);
    EXPECT_NEAR(size("width='595pt' height='842pt'").x, 595 * 25.4 / 72, 1e-9);
    EXPECT_NEAR(size("width='96' height='192px'").y, 50.8, 1e-9);
    EXPECT_NEAR(size("width='100mm' viewBox='0 0 50 20'").y, 40, 1e-9);
    EXPECT_NEAR(size("width='100%' height='100%' viewBox='0 0 20 10'", Paper{"a4", "", 210, 297}).x, 297, 1e-9);
    EXPECT_EQ(error_of([&] { size("viewBox='0 0 20 10'"); }),
              "2 page.svg:1: how large this drawing is on paper is not told; give its svg element a width and a height in mm, or "
              "name the "
              "paper with --paper");
    EXPECT_TRUE(error_of([&] { size("width='1e9mm' height='10mm'"); }).find("out of range") != std::string::npos);
    EXPECT_TRUE(error_of([&] { size("width='0' height='0'"); }).find("out of range") != std::string::npos);
    const FoundPage found = read("");
    EXPECT_EQ(found.page.live.left, 10);
    EXPECT_EQ(found.page.live.width, 180);
}

TEST(Svg, ReadsEveryShape) {
    expect_ends(stroke_of("<line x1='10' y1='20' x2='30' y2='40' stroke='black' stroke-linecap='round'/>"), {10, 20}, {30, 40});
    expect_ends(stroke_of("<polyline points='10,20 30 40,50-60' fill='none' stroke='black' stroke-linecap='round'/>"), {10, 20},
                {50, -60});
    const PageStroke round = stroke_of("<circle cx='50' cy='40' r='10' fill='none' stroke='black' stroke-width='2'/>");
    EXPECT_TRUE(round.closed);
    EXPECT_EQ(round.width, 2);
    for (const Point& p : round.points) EXPECT_NEAR(distance(p, {50, 40}), 10, 0.01);
    const PageStroke oval = stroke_of("<ellipse cx='50' cy='40' rx='20' ry='10' fill='none' stroke='black'/>");
    for (const Point& p : oval.points) EXPECT_NEAR(std::hypot((p.x - 50) / 20, (p.y - 40) / 10), 1, 0.002);
    const PageStroke box = stroke_of("<rect x='10' y='20' width='30' height='15' fill='none' stroke='black'/>");
    EXPECT_TRUE(box.closed);
    EXPECT_NEAR(length_of({box.points, true}), 90, 1e-9);
    const PageStroke soft = stroke_of("<rect x='10' y='20' width='30' height='15' rx='5' fill='none' stroke='black'/>");
    EXPECT_NEAR(length_of({soft.points, true}), 90 - 8 * 5 + 10 * std::numbers::pi, 0.02);
    EXPECT_EQ(read("<polygon points='0 0 50 0 50 50'/>").page.areas.size(), 1u);
    EXPECT_EQ(read("<rect width='0' height='5'/><circle r='0'/><path d=''/><path d='none'/><path/>").page.areas.size(), 0u);
}

TEST(Svg, ReadsEveryCommandOfAPath) {
    const auto path = [](const std::string& data) {
        return stroke_of("<path d='" + data + "' fill='none' stroke='black' stroke-linecap='round'/>");
    };
    expect_ends(path("M10 20 30 40 H50 V60 h-5 v-5 l1 1"), {10, 20}, {46, 56});
    expect_ends(path("m10,20 c10 0 10 10 20 10 s10 10 20 10 S80 50 80 60"), {10, 20}, {80, 60});
    expect_ends(path("M10 20q10 0 10 10t10 10T50 60Q60 60 60 70"), {10, 20}, {60, 70});
    const PageStroke half = path("M10 20a10 10 0 0120 0");  // flags without blanks
    expect_ends(half, {10, 20}, {30, 20});
    for (const Point& p : half.points) EXPECT_NEAR(distance(p, {20, 20}), 10, 0.01);
    EXPECT_LT(half.points[half.points.size() / 2].y, 11);
    const PageStroke large = path("M10 20A10 10 0 1 0 20 10");
    EXPECT_NEAR(length_of({large.points, false}), 15 * std::numbers::pi, 0.05);
    // Middle of a quadratic and a cubic curve, by their formulas.
    const auto has = [](const PageStroke& stroke, Point p) {
        double least = 1e9;
        for (std::size_t i = 1; i < stroke.points.size(); ++i)
            least = std::min(least, distance(p, nearest_on({stroke.points[i - 1], stroke.points[i]}, p)));
        return least < 0.011;
    };
    EXPECT_TRUE(has(path("M0 0Q40 80 80 0"), {40, 40}));
    EXPECT_TRUE(has(path("M0 0C0 80 80 80 80 0"), {40, 60}));
    const Page two = read("<path d='M0 0l9 0 0 9zm20 20l9 0 0 9z' fill='none' stroke='black'/>").page;
    ASSERT_EQ(two.strokes.size(), 2u);
    EXPECT_EQ(two.strokes[1].points[0].x, 20);
}

TEST(Svg, AppliesTransformsViewsAndUses) {
    const auto at = [](const std::string& body) { return stroke_of(body).points[0]; };
    const std::string line = "<line x1='10' y1='0' x2='20' y2='0' stroke='black' stroke-linecap='round'/>";
    EXPECT_NEAR(at("<g transform='translate(5 6)'>" + line + "</g>").y, 6, 1e-9);
    EXPECT_NEAR(at("<g transform='translate(100,50) rotate(90)'>" + line + "</g>").y, 60, 1e-9);
    EXPECT_NEAR(at("<g transform='rotate(90 10 10)'>" + line + "</g>").x, 20, 1e-9);
    EXPECT_NEAR(at("<g transform='matrix(2 0 0 3 1 1)'>" + line + "</g>").x, 21, 1e-9);
    EXPECT_NEAR(at("<g transform='skewX(45) translate(0 10)'>" + line + "</g>").x, 20, 1e-9);
    EXPECT_NEAR(stroke_of("<g transform='scale(2)'>" + line + "</g>").width, 2, 1e-9);
    EXPECT_NEAR(at("<svg x='50' width='40' height='20' viewBox='0 0 20 10'>" + line + "</svg>").x, 70, 1e-9);
    EXPECT_NEAR(at("<defs><g id='a'>" + line + "</g></defs><use xlink:href='#a' x='7'/>").x, 17, 1e-9);
    EXPECT_NEAR(at("<symbol id='a' viewBox='0 0 20 20'>" + line + "</symbol><use href='#a' width='40' height='40'/>").x, 20,
                1e-9);
    // A view of another shape stands in the middle of its page.
    const Page page = read("<line x1='0' y1='0' x2='10' y2='0' stroke='black' stroke-linecap='round'/>",
                           "<svg width='200mm' height='100mm' viewBox='0 0 10 10'>")
                          .page;
    EXPECT_NEAR(page.strokes[0].points[0].x, 50, 1e-9);
}

TEST(Svg, TakesDarkForInkAndTheRestForPaper) {
    const auto inked = [](const std::string& fill) {
        return read("<rect width='50' height='50' " + fill + "/>").page.areas.size() == 1;
    };
    EXPECT_TRUE(inked(""));
    for (const std::string dark :
         {"black", "#000", "#123", "#00f", "navy", "rgb(0%,0%,0%)", "rgb(10, 20, 30)", "Red", "hsl(120 100% 20%)", "#000000ff"})
        EXPECT_TRUE(inked("fill='" + dark + "'")) << dark;
    for (const std::string light : {"none", "white", "#fff", "#eeeeee", "yellow", "rgb(100%,100%,100%)", "transparent",
                                    "rgba(0,0,0,.2)", "#0001", "lightgrey"})
        EXPECT_FALSE(inked("fill='" + light + "'")) << light;
    EXPECT_FALSE(inked("fill-opacity='.3'"));
    EXPECT_FALSE(inked("opacity='.3'"));
    EXPECT_FALSE(inked("style='fill:none'"));
    EXPECT_FALSE(inked("fill='black' style='fill : white ; stroke:none'"));
    EXPECT_FALSE(inked("visibility='hidden'"));
    EXPECT_FALSE(inked("display='none'"));
    EXPECT_EQ(in_language(read("<rect width='50' height='50' fill='chartruse'/>").notes, "en"),
              std::vector<std::string>{"1 colour is not known, taken for black"});
}

TEST(Svg, ReadsSimpleStyleSheets) {
    const Page page = read(
                          "<style>/* of a drawing program */ .a, .b { fill: none; stroke: #000; stroke-width: 2px } "
                          "#c{stroke-width:3} line{stroke:black}</style>"
                          "<path class='x a' d='M0 0 50 0'/><path class='b' id='c' d='M0 9 50 9'/><line x2='50' y1='20' y2='20' "
                          "style='stroke-width:4'/>")
                          .page;
    ASSERT_EQ(page.strokes.size(), 3u);
    EXPECT_TRUE(page.areas.empty());
    EXPECT_EQ(page.strokes[0].width, 2);
    EXPECT_EQ(page.strokes[1].width, 3);
    EXPECT_EQ(page.strokes[2].width, 4);
    EXPECT_EQ(read("<style>g ~ path { fill: none }</style><path d='M0 0h9v9z'/>").notes.size(), 1u);
}

TEST(Svg, EndsLinesWhereTheirInkEnds) {
    // Flat ends: with round ones of a page the middle line is shorter by a width.
    expect_ends(stroke_of("<line x1='10' y1='20' x2='50' y2='20' stroke='black' stroke-width='2'/>"), {11, 20}, {49, 20});
    expect_ends(stroke_of("<path d='M10 20h.5h.2h39.3' fill='none' stroke='black' stroke-width='2'/>"), {11, 20}, {49, 20});
}

TEST(Svg, FillsAsTheRuleSays) {
    const auto rings = [](const std::string& more) {
        const Page page = read("<path d='M0 0h50v50h-50z M10 10h20v20h-20z' " + more + "/>").page;
        return page.areas.at(0).rings.size();
    };
    EXPECT_EQ(rings("fill-rule='evenodd'"), 2u);
    EXPECT_EQ(rings(""), 1u) << "both turn the same way: black all over";
    EXPECT_EQ(read("<path d='M0 0h50v50h-50z M10 10v20h20v-20z'/>").page.areas.at(0).rings.size(), 2u);
}

std::vector<PageStroke> dashes_of(const std::string& body) {
    std::vector<PageStroke> dashes = read(body).page.strokes;
    for (const PageStroke& dash : dashes) EXPECT_EQ(dash.role, Role::dash);
    return dashes;
}

TEST(Svg, DashedLinesAreTheirDashes) {
    // Round ends, so that nothing is cut back.
    const std::string head = "<g fill='none' stroke='black' stroke-linecap='round'>";
    auto dashes = dashes_of(head + "<path d='M0 10h50' stroke-dasharray='8 4'/></g>");
    ASSERT_EQ(dashes.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(dashes[i].points.front().x, 12.0 * static_cast<double>(i), 1e-9);
        EXPECT_NEAR(dashes[i].points.back().x, i == 4 ? 50 : 12.0 * static_cast<double>(i) + 8, 1e-9);
    }
    // An odd list is taken twice; the offset begins within it; percentages are of the view.
    dashes =
        dashes_of(head + "<path d='M0 10h30' style='stroke-dasharray:5,3,2;stroke-dashoffset:6'/></g>");  // 5-3 2-5 3-2 | 5-3 ...
    ASSERT_EQ(dashes.size(), 5u);
    EXPECT_NEAR(dashes[0].points.front().x, 2, 1e-9);
    EXPECT_NEAR(dashes[0].points.back().x, 4, 1e-9);
    EXPECT_NEAR(dashes[1].points.front().x, 9, 1e-9);
    // Round a corner a dash bends with its line.
    dashes = dashes_of(head + "<path d='M10 10h10v30' stroke-dasharray='15 5'/></g>");
    ASSERT_EQ(dashes.size(), 2u);
    ASSERT_EQ(dashes[0].points.size(), 3u);
    EXPECT_NEAR(dashes[0].points[2].y, 15, 1e-9);
    // A closed line's last dash goes on into its first.
    dashes = dashes_of(head + "<rect x='10' y='10' width='20' height='20' stroke-dasharray='12 4' stroke-dashoffset='6'/></g>");
    ASSERT_EQ(dashes.size(), 5u);
    EXPECT_EQ(dashes[0].points.size(), 3u);
    // These are whole.
    for (const std::string whole : {"none", "0", "0 0", "-1 2", "x"})
        EXPECT_EQ(read(head + "<path d='M0 10h50' stroke-dasharray='" + whole + "'/></g>").page.strokes.at(0).role, Role::line)
            << whole;
}

// Whatever the pattern: together they are as long as the share of the pattern that is black, and they lie on the line.
TEST(Svg, DashesAreAsLongAsTheirPatternSays) {
    for (const double dash : {0.5, 1.0, 3.0, 7.5, 40.0})
        for (const double gap : {0.25, 2.0, 11.0})
            for (const double offset : {-7.0, 0.0, 0.4, 100.0}) {
                const double period = dash + gap, length = 3 * 60.0;  // there and back and there
                double black = 0;
                for (double at = 0; at < length; at += 0.001)
                    black += std::fmod(at + offset + 100 * period, period) < dash ? 0.001 : 0;
                double drawn = 0;
                for (const PageStroke& one :
                     read("<path d='M10 50h60h-60h60' fill='none' stroke='black' stroke-linecap='round' stroke-dasharray='" +
                          to_text(dash) + " " + to_text(gap) + "' stroke-dashoffset='" + to_text(offset) + "'/>")
                         .page.strokes) {
                    drawn += length_of(Stroke{one.points, false});
                    for (const Point& p : one.points) EXPECT_TRUE(p.y == 50 && p.x >= 10 - 1e-9 && p.x <= 70 + 1e-9);
                }
                EXPECT_NEAR(drawn, black, 0.01) << dash << ' ' << gap << ' ' << offset;
            }
}

TEST(Svg, AnEmptyDrawingIsTold) {
    for (const std::string body : {"", "<text>a</text>", "<rect width='50' height='50' fill='white'/>"})
        EXPECT_TRUE(read(body).notes.at(0).english().starts_with(
            "nothing on this page is to be felt: no line or area is darker than half grey; draw in black"))
            << body;
}

TEST(Svg, TellsWhatItPassesOver) {
    const auto notes = read(
                           "<text>a</text><text>b</text><path d='M0 0h50' stroke='black' stroke-dasharray='.001' fill='none'/>"
                           "<rect width='50' height='50' fill='url(#hatch)'/><g clip-path='url(#c)'/><image "
                           "href='http://x/y.png' width='5' height='5'/>"
                           "<g transform='scale(1 3)'><path d='M0 0h50' stroke='black' marker-end='url(#m)'/></g>")
                           .notes;
    const std::vector<std::string> expected = {"2 texts or letters are not looked at by any rule",
                                               "1 line is dashed too finely and taken for whole",
                                               "1 pattern or gradient is taken for black",
                                               "1 clip path or mask is not applied",
                                               "1 marker is not looked at; those at the ends of lines are",
                                               "1 picture is not looked at; one upright PNG, JPEG or WebP within the file is",
                                               "1 line is wider in one direction, taken for even"};
    EXPECT_EQ(in_language(notes, "en"), expected);
}

TEST(Svg, SaysWhereItIsWrong) {
    const auto fault = [](const std::string& body) { return error_of([&] { read(body); }); };
    EXPECT_EQ(fault("<g>\n<path d='M0 0 L'/></g>"),
              "2 page.svg:3: this path cannot be read at \"\"; mend it or save the drawing again");
    EXPECT_EQ(fault("<path d='M0 0 L1 1 X2'/>"),
              "2 page.svg:2: this path cannot be read at \"2\"; mend it or save the drawing again");
    EXPECT_EQ(fault("<polygon points='1 2 3'/>"),
              "2 page.svg:2: these points are not pairs of numbers; mend them or save the drawing again");
    EXPECT_EQ(fault("<g transform='turn(3)'/>"), "2 page.svg:2: \"turn(3)\" is no transform; mend it or save the drawing again");
    EXPECT_EQ(fault("<circle cx='NaN' r='1'/>"), "2 page.svg:2: \"NaN\" is no length; mend the attribute cx");
    EXPECT_EQ(fault("<path d='M1e999 0'/>"),
              "2 page.svg:2: this path cannot be read at \"1e999 0\"; mend it or save the drawing again");
    EXPECT_EQ(fault("<line x1='1e300' x2='5' stroke='black'/>"),
              "2 page.svg:2: a place over 100 m away from the page is out of range; mend its coordinates");
    EXPECT_EQ(fault("<g transform='scale(1e200) scale(1e200)'><path d='M1 1h1v1z'/></g>"),
              "2 page.svg:2: a place over 100 m away from the page is out of range; mend its coordinates");
    EXPECT_TRUE(fault("<g></path>").starts_with("2 page.svg:2: this is not well-formed XML (mismatched tag, column "));
    EXPECT_TRUE(error_of([] {
                    read_svg("", "page.svg", 10, {});
                }).starts_with("2 page.svg:1: this is not well-formed XML (no element found"));
    EXPECT_EQ(error_of([] { read_svg("<html/>", "page.svg", 10, {}); }),
              "2 page.svg:1: this is XML but no SVG drawing; save it as SVG");
}

TEST(Svg, BoundsWhatAHostileFileMayCost) {
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<g>";
    EXPECT_EQ(error_of([&] { read(deep); }), "2 page.svg:2: its groups are nested too deeply; ungroup some");
    EXPECT_EQ(error_of([] { read("<g id='a'><use href='#a'/></g>"); }),
              "2 page.svg:2: parts of this drawing use each other without end; mend it or save the drawing again");
    std::string bomb = "<defs><path id='u0' d='M0 0h1v1z'/>";
    for (int i = 1; i < 12; ++i) {
        bomb += "<g id='u" + std::to_string(i) + "'>";
        for (int k = 0; k < 10; ++k) bomb += "<use href='#u" + std::to_string(i - 1) + "'/>";
        bomb += "</g>";
    }
    EXPECT_TRUE(error_of([&] { read(bomb + "</defs><use href='#u11'/>"); }).find("uses its parts over a million times") !=
                std::string::npos);
    std::string laughs = "<!DOCTYPE svg [<!ENTITY a0 'ha'>";
    for (int i = 1; i < 12; ++i) {
        laughs += "<!ENTITY a" + std::to_string(i) + " '";
        for (int k = 0; k < 10; ++k) laughs += "&a" + std::to_string(i - 1) + ";";
        laughs += "'>";
    }
    EXPECT_NE(
        error_of([&] { read_svg(laughs + "]><svg width='9mm' height='9mm'><title>&a11;</title></svg>", "page.svg", 1, {}); }),
        "no error");
    // Entities as drawing programs use them are fine; files outside are never opened.
    EXPECT_EQ(error_of([] {
                  read_svg("<!DOCTYPE svg [<!ENTITY ns 'http://x/'>]><svg width='9mm' height='9mm' a='&ns;'/>", "page.svg", 1,
                           {});
              }),
              "no error");
    EXPECT_EQ(
        read_svg("<!DOCTYPE svg [<!ENTITY f SYSTEM '/etc/hostname'>]><svg width='9mm' height='9mm'><title>&f;</title></svg>",
                 "page.svg", 1, {})
            .page.title,
        "");
}

// What our own format writes comes back: lines, widths, areas, braille and a picture.
TEST(Svg, ReadsTheProductsOwnPages) {
    const Sheet sheet = rendered::sheet_of("a4", "The quick brown fox");
    for (const Page& own : {lay_out(rendered::hard_drawing(), sheet), lay_out(rendered::picture_drawing(801, 603), sheet)}) {
        Page found = read_svg(rendered::encode(own, "svg"), "page.svg", 12.7, {}).page;
        EXPECT_NEAR(found.width, own.width, 1e-3);
        EXPECT_NEAR(found.live.width, own.live.width, 1e-3);
        // The file has them layer by layer.
        std::vector<PageStroke> strokes = own.strokes;
        for (auto* all : {&strokes, &found.strokes})
            std::sort(all->begin(), all->end(),
                      [](const PageStroke& a, const PageStroke& b) { return a.points[0].x < b.points[0].x; });
        ASSERT_EQ(found.strokes.size(), strokes.size());
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            EXPECT_NEAR(found.strokes[i].width, strokes[i].width, 0.006);
            EXPECT_EQ(found.strokes[i].closed, strokes[i].closed);
            EXPECT_EQ(found.strokes[i].role, strokes[i].role);
            EXPECT_NEAR(distance(found.strokes[i].points[0], strokes[i].points[0]), 0, 0.01);
            EXPECT_NEAR(distance(found.strokes[i].points.back(), strokes[i].points.back()), 0, 0.01);
        }
        ASSERT_EQ(found.areas.size(), own.areas.size());
        for (std::size_t i = 0; i < own.areas.size(); ++i) EXPECT_EQ(found.areas[i].rings.size(), own.areas[i].rings.size());
        ASSERT_EQ(found.braille.size(), own.braille.size());
        EXPECT_EQ(found.braille.at(0).cells, own.braille.at(0).cells);
        EXPECT_NEAR(distance(found.braille[0].first_dot, own.braille[0].first_dot), 0, 0.01);
        EXPECT_NEAR(found.cell.dot_pitch, 2.5, 0.01);
        EXPECT_NEAR(found.cell.cell_pitch, 6, 0.01);
        EXPECT_NEAR(found.braille_dot, 1.6, 0.01);
        ASSERT_EQ(found.picture.has_value(), own.picture.has_value());
        EXPECT_TRUE(!own.picture || found.picture->bits == own.picture->bits);
    }
}

// The same drawing, drawn by librsvg from the file and by us from the page that was read.
TEST(Svg, IsReadAsLibrsvgDrawsIt) {
    NEED_TOOL("rsvg-convert");
    const rendered::FileFolder folder;
    const std::string svg =
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='8in' height='4in' viewBox='0 "
        "0 200 100'>"
        "<style>.t{stroke:#000;stroke-width:3;fill:none}</style>"
        "<g transform='translate(20 10) rotate(20) scale(1.3 1.3)' stroke-linecap='round' stroke-linejoin='round'>"
        "<path class='t' d='M0 0c20-30 40 30 60 0s20 40-10 30q-20-10-30 5t-20-2a12 8 30 1 1 5 9z'/>"
        "<ellipse cx='80' cy='-10' rx='12' ry='6' fill='#222'/><rect x='70' y='10' width='25' height='14' rx='4' ry='6'/>"
        "<path d='M100 0h20v20h-20zM105 5h10v10h-10z' fill-rule='evenodd'/><path d='M100-30h20v20h-20zM105-25h10v10h-10z'/>"
        "<path d='M100 30h20v20h-20zM105 35v10h10v-10z'/></g>"
        "<svg x='10' y='60' width='50' height='35' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMin'><circle cx='5' cy='5' "
        "r='4' stroke='black' stroke-width='1' fill='none'/></svg>"
        "<defs><polygon id='p' points='0,0 12,0 6,9'/></defs><use xlink:href='#p' x='150' y='80'/><use xlink:href='#p' "
        "transform='matrix(1 .5 -.5 1 170 75)'/></svg>";
    const FoundPage found = read_svg(svg, "page.svg", 10, {});
    EXPECT_EQ(in_language(found.notes, "en"), std::vector<std::string>{});
    const auto expected = rendered::by_librsvg(folder, svg, 150);
    const auto got = rendered::parse_png(rendered::encode(found.page, "png", {{"dpi", "150"}}));
    ASSERT_EQ(expected.width, got.width);
    EXPECT_GT(got.count(), 30'000);
    EXPECT_EQ(rendered::disagreements(expected, got, 1), 0);
}

}  // namespace
}  // namespace tactics::svg_test
