// SPDX-License-Identifier: Apache-2.0
// SVG figures as drawings with words.
#include "tactics/readers/svg/figure.h"

#include <gtest/gtest.h>

#include "tactics/readers/svg/clip.h"
#include "tactics/readers/svg/plain_words.h"
#include "tests/tactics/readers/svg/figures.h"

namespace tactics::figure_test {
namespace {

using tests::figure;

TEST(Figure, TextsAreWordsWhereTheyStand) {
    const auto words = figure(
                           "<text x='20' y='50' font-size='10'>Rain</text>"
                           "<text x='100' y='50' style='font: 10px serif; text-anchor: middle'>Rain &amp; wind</text>"
                           "<text transform='translate(10 80) rotate(-90)' font-size='4'>Height</text>"
                           "<text font-size='5'><tspan x='5' y='10'>One</tspan><tspan x='5' y='16'>Two</tspan></text>"
                           "<text x='5' y='30' font-size='5'>a <tspan font-weight='bold'>b</tspan> c</text>")
                           .words;
    ASSERT_EQ(words.size(), 6u);
    EXPECT_EQ(words[0].text, "Rain");
    EXPECT_NEAR(words[0].middle.x, 20 + 11, 3);
    EXPECT_NEAR(words[0].middle.y, 46.4, 0.5);
    EXPECT_EQ(words[1].text, "Rain & wind");
    EXPECT_NEAR(words[1].middle.x, 100, 1e-9);
    EXPECT_TRUE(words[2].upwards);
    EXPECT_NEAR(words[2].middle.y, 80 - 6.6, 2);
    EXPECT_EQ(words[3].text, "One");
    EXPECT_EQ(words[4].text, "Two");
    EXPECT_EQ(words[5].text, "a b c");
}

TEST(Figure, PowersAndMarkup) {
    const auto words = figure(
                           "<g transform='translate(33 50)'><text>\n <tspan style='font: 10px x' x='0 6' y='-1'>10</tspan>\n "
                           "<tspan style='font: 7px x' x='13' y='-4.8'>4</tspan>\n</text></g>")
                           .words;
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "10\u2074");
    EXPECT_EQ(without_markup("$\\mathdefault{10^{-2}}$"), "10\u207b\u00b2");
    EXPECT_EQ(without_markup("5 $"), "5 $");
}

std::vector<std::string> said(const std::string& body) {
    std::vector<std::string> texts;
    for (const FoundWords& words : figure(body).words) texts.push_back(words.text);
    return texts;
}

using Said = std::vector<std::string>;

TEST(Figure, PartsOfATextThatStandApartAreWordsOfTheirOwn) {
    EXPECT_EQ(said("<text y='20' font-size='10'><tspan x='10'>Venus</tspan><tspan x='80'>Earth</tspan><tspan "
                   "x='150'>Mars</tspan></text>"),
              (Said{"Venus", "Earth", "Mars"}));
    EXPECT_EQ(said("<text x='10' y='20' font-size='10'>H<tspan dy='3' font-size='7'>2</tspan><tspan dy='-3'>O</tspan></text>"),
              Said{"H2O"});
    EXPECT_EQ(said("<text x='10' y='20' font-size='10'>m/s<tspan baseline-shift='super' font-size='7'>2</tspan></text>"),
              Said{"m/s\u00b2"});
    EXPECT_EQ(said("<text font-size='10' text-anchor='middle'><tspan x='50' y='20'>Cell</tspan><tspan x='50' "
                   "dy='1.2em'>wall</tspan></text>"),
              (Said{"Cell", "wall"}));
    EXPECT_EQ(said("<text x='10 16 22 28' y='20' font-size='10'>Rain</text>"), Said{"Rain"});
}

TEST(Figure, SizesOfLettersAreThoseOfTheStyleSheet) {
    const auto words = figure(
                           "<style>.big{font:italic 20px/1.2 serif} .half{font-size:50%}</style>"
                           "<g class='big'><text x='10' y='50'>A<tspan class='half' x='100' y='50'>B</tspan></text></g>")
                           .words;
    ASSERT_EQ(words.size(), 2u);
    EXPECT_NEAR(words[0].height, 0.72 * 20, 1e-9);
    EXPECT_NEAR(words[1].height, 0.72 * 10, 1e-9);
}

TEST(Figure, TextOnAPathStandsThere) {
    const auto words = figure(
                           "<defs><path id='p' d='M100 10 V90'/></defs>"
                           "<text font-size='5'><textPath href='#p' startOffset='50%'>Ash</textPath></text>"
                           "<text font-size='5' text-anchor='middle'><textPath href='#p' startOffset='50%'>Elm</textPath></text>")
                           .words;
    ASSERT_EQ(words.size(), 2u);
    EXPECT_TRUE(words[0].upwards);
    EXPECT_NEAR(words[0].middle.y, 54, 2);
    EXPECT_NEAR(words[1].middle.y, 50, 1e-6);
    EXPECT_NEAR(words[1].middle.x, 101.8, 0.1);
}

TEST(Figure, OfASwitchOneChildIsDrawn) {
    EXPECT_EQ(said("<switch><text systemLanguage='de' x='9' y='9'>Kern</text><text x='9' y='9'>Core</text></switch>"),
              Said{"Core"});
    EXPECT_EQ(said("<switch><foreignObject width='100%' height='100%'><div>Order of goods</div></foreignObject>"
                   "<text x='50' y='50'>Order o...</text></switch>"),
              Said{"Order of goods"});
    const auto words =
        figure("<foreignObject x='20' y='30' width='60' height='20'><p>Ask a</p><p>question</p></foreignObject>").words;
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "Ask a question");
    EXPECT_NEAR(words[0].middle.x, 50, 1e-9);
    EXPECT_NEAR(words[0].middle.y, 40, 1e-9);
}

TEST(Figure, WordsThatFlowInARegionStandInItsMiddle) {
    const auto words = figure(
                           "<flowRoot font-size='5'><flowRegion><rect x='20' y='30' width='60' height='20'/></flowRegion>"
                           "<flowPara>Ask a</flowPara><flowPara>question</flowPara></flowRoot>")
                           .words;
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "Ask a question");
    EXPECT_NEAR(words[0].middle.x, 50, 1e-9);
    EXPECT_NEAR(words[0].middle.y, 40, 1e-9);
}

// Heads that are filled stay full, whichever way they are drawn; a bar of that size does not.
TEST(Figure, SmallDarkSignsStayFull) {
    const auto areas = [](const std::string& body) { return figure(body).page.areas.size(); };
    EXPECT_EQ(areas("<path d='M20 20 l10 4 l-10 4 z'/>"), 1u);
    EXPECT_EQ(areas("<path d='M20 20 l10 4 l-10 4 z' stroke='black'/>"), 1u);
    EXPECT_EQ(areas("<ellipse cx='20' cy='20' rx='4' ry='3'/>"), 1u);
    EXPECT_EQ(areas("<path d='M20 20 l10 4 l-10 4 z' fill='#eee'/>"), 0u);
    EXPECT_EQ(areas("<rect x='20' y='20' width='8' height='10'/>"), 0u);
    EXPECT_EQ(areas("<path d='M20 20 l30 12 l-30 12 z'/>"), 0u);
    const FoundPage arrow = figure(
        "<marker id='m' viewBox='0 0 10 10' refX='9' refY='5' markerWidth='8' markerHeight='8' orient='auto'><path d='M0,0 L10,5 "
        "L0,10 z'/>"
        "</marker><path d='M20 50 H80' stroke='black' marker-end='url(#m)'/>");
    ASSERT_EQ(arrow.page.areas.size(), 1u);
    EXPECT_EQ(arrow.page.areas[0].role, Role::arrow);
}

TEST(Figure, GradientsAreTheirMean) {
    const std::string defs =
        "<defs><linearGradient id='white'><stop offset='0' stop-color='white'/><stop offset='1' "
        "style='stop-color:#fafafa'/></linearGradient>"
        "<linearGradient id='same' href='#white'/><radialGradient id='grey'><stop stop-color='#000'/><stop offset='1' "
        "stop-color='#fff'/>"
        "</radialGradient><radialGradient id='shade'><stop stop-color='#000'/><stop offset='1' stop-color='#000' "
        "stop-opacity='0'/>"
        "</radialGradient><filter id='soft'><feGaussianBlur stdDeviation='2'/></filter></defs><rect x='1' y='1' width='9' "
        "height='9'/>";
    const auto lines = [&](const std::string& shape) { return figure(defs + shape).page.strokes.size() - 1; };
    EXPECT_EQ(lines("<rect x='20' y='20' width='50' height='50' fill='url(#white)'/>"), 0u);
    EXPECT_EQ(lines("<rect x='20' y='20' width='50' height='50' fill='url(#same)'/>"), 0u);
    EXPECT_EQ(lines("<rect x='20' y='20' width='50' height='50' fill='url(#grey)'/>"), 1u);
    EXPECT_EQ(lines("<rect x='20' y='20' width='50' height='50' fill='url(#shade)'/>"), 0u);
    EXPECT_EQ(lines("<g filter='url(#soft)'><rect x='20' y='20' width='50' height='50' fill-opacity='.3'/></g>"), 0u);
    EXPECT_EQ(lines("<g filter='url(#soft)'><rect x='20' y='20' width='50' height='50'/></g>"), 1u);
    EXPECT_EQ(lines("<rect x='20' y='20' width='50' height='50' fill='red' fill-opacity='.3'/>"), 1u) << "of a Venn diagram";
    EXPECT_EQ(in_language(figure(defs + "<rect x='20' y='20' width='50' height='50' fill='url(#shade)'/>").notes, "en"),
              Said{"1 mostly clear shadow or gleam is left out"});
}

TEST(Figure, StyleSheetsKnowWhatIsWithinWhat) {
    const auto lines = [](const std::string& css) {
        return figure("<style>" + css +
                      "</style><g class='axis' id='x'><path class='domain' d='M10 10 V50 H90'/></g>"
                      "<line x1='10' x2='90' stroke='black'/>")
                   .page.strokes.size() -
               1;
    };
    EXPECT_EQ(lines(".axis path{fill:none}"), 0u);
    EXPECT_EQ(lines("#x > path.domain{fill:none;stroke:black}"), 1u);
    EXPECT_EQ(lines("#x g path{fill:none}"), 1u);
    EXPECT_EQ(lines(".axis > .domain{fill:none} path{fill:red}"), 0u) << "the more particular wins";
    EXPECT_EQ(lines("path{fill:red} path{fill:none}"), 0u) << "the later wins";
    EXPECT_EQ(lines(".axis{color:white} path{fill:currentColor}"), 0u);
}

TEST(Figure, OfAStyleSheetWithoutEndTheRestIsTold) {
    std::string css;
    for (int i = 0; i < 300; ++i) css += "g path.c{stroke-width:2}";
    EXPECT_EQ(in_language(figure("<style>" + css + "</style><g><path class='c' d='M10 10 H90' stroke='black'/></g>").notes, "en"),
              Said{"100 selectors of style sheets are not understood; tags, classes and ids are"});
}

// One length, one drawing: the same in any size on a screen.
TEST(Figure, IsTheSameInAnySize) {
    const auto read_at = [](const std::string& size) {
        return read_svg("<svg xmlns='http://www.w3.org/2000/svg' " + size +
                            " viewBox='0 0 16 16'><path d='M1 1h14v14H1z' fill='#333'/><circle cx='8' cy='8' r='.1'/></svg>",
                        "icon.svg", 0, std::nullopt, SvgPurpose::figure);
    };
    const FoundPage small = read_at("width='16' height='16'"), large = read_at("width='48cm' height='48cm'");
    ASSERT_EQ(small.page.strokes.size(), 1u);
    EXPECT_EQ(small.page.areas.size(), large.page.areas.size());
    ASSERT_EQ(large.page.strokes.size(), 1u);
    EXPECT_NEAR(small.page.strokes[0].points[1].x, large.page.strokes[0].points[1].x, 1e-9);
    EXPECT_FALSE(small.tells_size);
    EXPECT_TRUE(large.tells_size);
    EXPECT_NEAR(large.file_width, 480, 1e-9);
}

TEST(Figure, OfWhiteOnNothingOrOfGleamsOnlyIsNotBlank) {
    const FoundPage white = figure("<path d='M20 20 H90 V90 H20 Z' fill='#fff'/>");
    EXPECT_EQ(white.page.strokes.size(), 1u);
    EXPECT_EQ(in_language(white.notes, "en"), Said{"all of it is white or nearly so, and taken to stand on a dark ground"});
    EXPECT_EQ(figure("<linearGradient id='a'><stop/><stop offset='1' stop-opacity='0'/></linearGradient>"
                     "<path d='M20 20 H90 V90 H20 Z' fill='url(#a)'/>")
                  .page.strokes.size(),
              1u);
}

TEST(Figure, APathWithAFaultIsDrawnUpToIt) {
    const FoundPage found = figure("<path d='M10 10 H90 V50 h' fill='none' stroke='black'/>");
    ASSERT_EQ(found.page.strokes.size(), 1u);
    EXPECT_EQ(found.page.strokes[0].points.size(), 3u);
    EXPECT_EQ(in_language(found.notes, "en"), Said{"1 path has a fault and is drawn up to it"});
}

TEST(Figure, ALightEdgeBeneathLettersIsNoSecondWord) {
    EXPECT_EQ(said("<text x='9' y='9' stroke='white' stroke-width='4'>Old town</text><text x='9' y='9'>Old town</text>"
                   "<text x='9' y='60'>Old town</text>"),
              (Said{"Old town", "Old town"}));
}

TEST(Figure, LettersOfAFormulaSayTheirCodes) {
    const std::string defs =
        "<defs><path id='MJX-1-A' d='M0 0H400V400H0Z'/><path id='MJX-1-B' d='M0 0H500V450H0Z'/></defs>"
        "<g data-mml-node='math' transform='translate(20 50) scale(.02 -.02)'>";
    EXPECT_EQ(
        said(defs + "<g><use data-c='1D465' href='#MJX-1-A'/></g><g transform='translate(450)'><use data-c='32' href='#MJX-1-B'/>"
                    "</g></g>"),
        Said{""});
    // One above the line of the other: what they say together is not known, and told as a whole.
    const auto words = figure(defs +
                              "<g><use data-c='1D465' href='#MJX-1-A'/></g><g transform='translate(450 363) scale(.7)'>"
                              "<use data-c='32' href='#MJX-1-B'/></g></g>")
                           .words;
    ASSERT_EQ(words.size(), 1u);
    EXPECT_TRUE(words[0].text.empty());
    EXPECT_TRUE(words[0].letters.empty());
}

// As Matplotlib and Inkscape write letters as shapes; the frame around them is drawn.
TEST(Figure, LettersThatAreShapesAreWordsNotLines) {
    const FoundPage found = figure(
        "<g id='text_1'><g id='patch_9'><path d='M10 10 H50 V30 H10 Z' fill='white' stroke='black'/></g>"
        "<!-- Clouds --><g><path d='M20 15 h4 v8 h-4 z'/><path d='M26 15 h4 v8 h-4 z'/></g></g>"
        "<path aria-label='Sea' d='M100 40 h20 v8 h-20 z'/>"
        "<g aria-label='an axis' role='graphics-symbol'><path d='M0 90 H200' stroke='black'/></g>");
    ASSERT_EQ(found.words.size(), 2u);
    EXPECT_EQ(found.words[0].text, "Clouds");
    EXPECT_NEAR(found.words[0].middle.x, 25, 1e-6);
    EXPECT_NEAR(found.words[0].middle.y, 19, 1e-6);
    EXPECT_EQ(found.words[1].text, "Sea");
    EXPECT_NEAR(found.words[1].middle.x, 110, 1e-6);
    EXPECT_EQ(found.page.strokes.size(), 2u);
    EXPECT_TRUE(found.page.areas.empty());
}

TEST(Figure, SurfacesBecomeOutlinesAndMarksStayFull) {
    const FoundPage found = figure(
        "<rect width='200' height='100' fill='white'/><rect x='10' y='10' width='30' height='50' fill='#ff7f0e'/>"
        "<circle cx='100' cy='50' r='1.5' fill='#ff7f0e'/><path d='M0 95 H200' stroke='#b0b0b0'/>");
    EXPECT_EQ(found.page.strokes.size(), 1u);
    EXPECT_TRUE(found.page.strokes.at(0).closed);
    EXPECT_EQ(found.page.areas.size(), 1u);
    EXPECT_EQ(in_language(found.notes, "en"),
              (std::vector<std::string>{"1 pale line is left out, such as those of a grid; darken them to have them drawn"}));
}

// The path touches the border of the page on both sides.
TEST(Figure, IsTheSameInAllUnits) {
    std::vector<Drawing> drawings;
    for (const std::string size : {"16px", "48px", "480px", "37mm"})
        drawings.push_back(drawing_of_figure(
            read_svg(
                "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 22 22' width='" + size + "' height='" + size +
                    "'><path fill='#7f8c8d' d='M1.818 4A1.815 1.815 0 0 0 0 5.818v10.364C0 17.189.811 18 1.818 18h18.364A1.815 "
                    "1.815 0 0 0 22 16.182V5.818A1.815 1.815 0 0 0 20.182 4z'/></svg>",
                "figure.svg", 0, std::nullopt, SvgPurpose::figure),
            170));
    for (const Drawing& drawing : drawings) {
        ASSERT_EQ(drawing.strokes.size(), 1u);
        EXPECT_TRUE(drawing.strokes[0].closed);
        ASSERT_EQ(drawing.strokes[0].points.size(), drawings[0].strokes[0].points.size());
        for (std::size_t i = 0; i < drawing.strokes[0].points.size(); ++i) {
            EXPECT_EQ(drawing.strokes[0].points[i].x, drawings[0].strokes[0].points[i].x);
            EXPECT_EQ(drawing.strokes[0].points[i].y, drawings[0].strokes[0].points[i].y);
        }
    }
}

TEST(Figure, IsCutAtItsClip) {
    const FoundPage found = figure(
        "<defs><clipPath id='c'><rect x='50' y='20' width='100' height='60'/></clipPath></defs>"
        "<path clip-path='url(#c)' d='M0 50 H200 V200 H100 V0' fill='none' stroke='black'/>"
        "<path d='M0 5 H300' stroke='black'/>");
    ASSERT_EQ(found.page.strokes.size(), 3u);
    EXPECT_NEAR(found.page.strokes[0].points.front().x, 50, 1e-6);
    EXPECT_NEAR(found.page.strokes[0].points.back().x, 150, 1e-6);
    EXPECT_NEAR(found.page.strokes[1].points.front().y, 80, 1e-6);
    EXPECT_NEAR(found.page.strokes[2].points.back().x, 200, 1e-6);
    EXPECT_TRUE(found.notes.empty());
}

// Against a naive twin: a line in small steps, each inside or not.
TEST(Figure, ClippingAgreesWithSmallSteps) {
    std::uint32_t state = 5;
    const auto next = [&](double most) {
        state = state * 1664525u + 1013904223u;
        return most * (state >> 8) / (1u << 24);
    };
    const Rect rect{20, 30, 50, 40};
    for (int round = 0; round < 100; ++round) {
        std::vector<Point> line;
        for (int i = 0; i < 6; ++i) {
            const double x = next(100), y = next(100);
            line.push_back({x, y});
        }
        double kept = 0, stepped = 0;
        for (const auto& part : clipped(line, true, rect)) kept += length_of(Stroke{part, false});
        constexpr int kSteps = 4000;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Point a = line[i], b = line[(i + 1) % line.size()];
            for (int k = 0; k < kSteps; ++k) {
                const double t = (k + 0.5) / kSteps;
                if (lies_in({{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}}, rect)) stepped += distance(a, b) / kSteps;
            }
        }
        EXPECT_NEAR(kept, stepped, 0.3) << round;
    }
}

TEST(Figure, LinesKeepTheirOrderOfWidthAndTheirPlace) {
    const FoundPage found = figure(
        "<g stroke='black' fill='none'><path d='M0 0 H200 V100' stroke-width='0.3'/><path d='M0 50 H200' stroke-width='0.6'/>"
        "<path d='M10 10 h9' stroke-width='2'/><path d='M0 50 H200' stroke-width='0.6'/></g>");
    const Drawing drawing = drawing_of_figure(found, 400);
    EXPECT_DOUBLE_EQ(drawing.height, 200);
    ASSERT_EQ(drawing.strokes.size(), 3u);  // one was there twice
    EXPECT_EQ(drawing.strokes[0].line, LineClass::thin);
    EXPECT_EQ(drawing.strokes[1].line, LineClass::normal);
    EXPECT_EQ(drawing.strokes[2].line, LineClass::thick);
    EXPECT_NEAR(drawing.strokes[0].points[1].x, 400, 1);
    EXPECT_NEAR(drawing.strokes[1].points[0].y, 100, 1e-6);
}

FoundPage page_of_lines(std::vector<std::vector<Point>> lines, bool closed = false) {
    FoundPage found;
    found.page.width = 200;
    found.page.height = 100;
    for (auto& points : lines) found.page.strokes.push_back({std::move(points), closed, 0.5});
    return found;
}

TEST(Figure, WhatIsDrawnTwiceIsFeltOnce) {
    const auto count = [](const FoundPage& page) { return drawing_of_figure(page, 200).strokes.size(); };
    const std::vector<Point> line{{20, 20}, {50, 60}, {90, 20}};
    for (const double off : {0.0, 0.004, -0.004, 0.0069, -0.0069}) {
        std::vector<Point> other = line;
        for (Point& p : other) p = {p.x + off, p.y - off};
        EXPECT_EQ(count(page_of_lines({line, other})), 1u) << off;
    }
    for (std::size_t i = 0; i < line.size(); ++i) {
        std::vector<Point> other = line;
        other[i].y += 0.011;
        EXPECT_EQ(count(page_of_lines({line, other})), 2u) << i;
    }
    EXPECT_EQ(count(page_of_lines({line, {line[2], line[1], line[0]}})), 2u);
    EXPECT_EQ(count(page_of_lines({line, {line[0], line[2]}})), 2u);
    EXPECT_EQ(count(page_of_lines({line, line}, true)), 1u);
    // Many, all from one place; comparing each with each would take half a minute.
    std::vector<std::vector<Point>> rays;
    for (int twice = 0; twice < 2; ++twice)
        for (int i = 0; i < 50'000; ++i) rays.push_back({{100, 50}, {0.004 * i, i % 2 == 0 ? 0.0 : 100.0}});
    const std::size_t rays_left = count(page_of_lines(rays));
    EXPECT_LE(rays_left, 25'000u);
    EXPECT_GT(rays_left, 10'000u);
}

}  // namespace
}  // namespace tactics::figure_test
