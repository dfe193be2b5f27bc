// SPDX-License-Identifier: Apache-2.0
// Grounds, grids and legends of figures: what serves the eye only.
#include "tactics/readers/svg/chart_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tactics/layout/texture.h"
#include "tactics/readers/svg/figure.h"
#include "tactics/readers/svg/plain_words.h"
#include "tactics/readers/svg/svg_dashes.h"
#include "tests/tactics/readers/svg/figures.h"

namespace tactics::chart_parts_test {
namespace {

using tests::figure;

const FoundWords& words_named(const FoundPage& figure, std::string_view text) {
    static const FoundWords none;
    for (const FoundWords& words : figure.words)
        if (words.text == text) return words;
    ADD_FAILURE() << text;
    return none;
}

// A figure and its negative are the same to a finger.
TEST(Ground, LightOnDarkIsDrawnAsDarkOnLight) {
    const auto drawn = [](const std::string& ground, const std::string& line, const std::string& pale) {
        return figure("<rect width='200' height='100' fill='" + ground + "'/><rect x='20' y='10' width='160' height='80' fill='" +
                      ground + "'/>" + "<path d='M20 90 L100 20 L180 60' fill='none' stroke='" + line +
                      "'/><path d='M20 50 H180' stroke='" + pale + "'/>");
    };
    for (const auto& page :
         {drawn("white", "black", "#c8c8c8"), drawn("black", "white", "#373737"), drawn("#202030", "#8dd3c7", "#444")}) {
        ASSERT_EQ(page.page.strokes.size(), 1u);
        EXPECT_EQ(page.page.strokes[0].points.size(), 3u);
        EXPECT_TRUE(page.page.areas.empty());
    }
    // What is dark and covers the page, but not first, or is no rectangle, is a part of the drawing.
    EXPECT_EQ(figure("<path d='M0 50 H200' stroke='black'/><rect width='200' height='100' fill='black'/>").page.strokes.size(),
              1u)
        << "it hides what is behind it";
    EXPECT_EQ(figure("<ellipse cx='100' cy='50' rx='100' ry='50' fill='black'/>").page.strokes.size(), 1u);
}

TEST(Grid, GoesAndAxesTicksAndTablesStay) {
    std::string grid, table, ticks;
    for (const int y : {20, 40, 60, 80}) {
        grid += "<path d='M20 " + std::to_string(y) + " H180' stroke='gray' stroke-dasharray='2,4'/>";
        table += "<path d='M20 " + std::to_string(y) + " H180' stroke='black'/>";
        ticks += "<path d='M20 " + std::to_string(y) + " h4' stroke='gray'/>";
    }
    // The legend interrupts one of them.
    const FoundPage with =
        figure(grid +
               "<path d='M20 30 H120 M160 30 H180' stroke='gray' stroke-dasharray='2,4'/>"
               "<path d='M20 10 V90 H180' fill='none' stroke='black'/><path d='M20 50 H180' stroke='red' stroke-dasharray='4'/>");
    EXPECT_EQ(with.page.strokes.size(), 2u);
    EXPECT_EQ(in_language(with.notes, "en"),
              (std::vector<std::string>{"6 lines of a grid are left out; draw them in black and whole to have them drawn"}));
    EXPECT_EQ(figure(table).page.strokes.size(), 4u);
    EXPECT_EQ(figure(ticks).page.strokes.size(), 4u);
}

// Its text may be a megabyte, and thousands of lines have it.
TEST(Looks, KeepOneCopyOfEachKindOfDashes) {
    FoundPage found;
    const std::string one(100000, '1'), other = one + "2";
    for (const std::string& dashes : {one, other, one, std::string(), std::string("none"), one}) {
        Style style;
        style.dashes = dashes;
        found.page.strokes.push_back({{{0, 0}, {9, 0}}, false, 1, Role::line});
        add_look(found, found.page.strokes.size() - 1, 0, style, Ground(SvgLook::plain));
    }
    ASSERT_EQ(found.looks.size(), 6u);
    EXPECT_EQ(found.dash_kinds.size(), 2u);
    for (const std::size_t i : {2u, 5u}) EXPECT_EQ(found.looks[i].dashes, found.looks[0].dashes);
    EXPECT_NE(found.looks[1].dashes, found.looks[0].dashes);
    for (const std::size_t i : {3u, 4u}) EXPECT_EQ(found.looks[i].dashes, 0u);
    std::string pattern;
    for (int i = 0; i < 5000; ++i) pattern += "5,3,";
    EXPECT_EQ(parse_dashes(pattern, "", 100, 1).lengths.size(), 1000u);
}

TEST(Legend, NamesTheCurvesThemselves) {
    const std::string curves =
        "<path d='M20 90 L180 20' fill='none' stroke='#1f77b4'/><path d='M20 20 L180 90' fill='none' stroke='#ff7f0e'/>"
        "<path d='M20 95 L180 80' fill='none' stroke='#1f77b4' stroke-dasharray='3 1'/>";
    const std::string legend =
        "<rect x='118' y='2' width='44' height='24' fill='white' stroke='black'/>"
        "<path d='M120 6 h12' stroke='#1f77b4'/><text x='135' y='7.4' font-size='4'>Supply</text>"
        "<path d='M120 13 h12' stroke='#ff7f0e'/><circle cx='126' cy='13' r='1' fill='#ff7f0e'/><text x='135' y='14.4' "
        "font-size='4'>Demand</text>"
        "<path d='M120 20 h12' stroke='#1f77b4' stroke-dasharray='3 1'/><text x='135' y='21.4' font-size='4'>Stock</text>";
    const FoundPage found = figure(curves + legend + "<text x='2' y='6' font-size='4'>Price</text>");
    EXPECT_EQ(found.page.strokes.size(), 3u);  // samples, their mark and the frame are gone
    EXPECT_TRUE(found.page.areas.empty());
    for (const auto& [text, stroke] : {std::pair{"Supply", 0u}, {"Demand", 1u}, {"Stock", 2u}}) {
        const auto& thing = words_named(found, text).thing;
        ASSERT_TRUE(thing) << text;
        const Point a = found.page.strokes[stroke].points.front(), b = found.page.strokes[stroke].points.back();
        EXPECT_NEAR(distance(a, *thing) + distance(*thing, b), distance(a, b), 1e-6) << text;
    }
    EXPECT_FALSE(words_named(found, "Price").thing);
    EXPECT_EQ(
        found.notes.back().english(),
        "of its legend these words \"Supply\", \"Demand\", \"Stock\" each name what is drawn as their sample, and stand there");
    EXPECT_EQ(found.page.strokes[2].role, Role::dash);
}

// Entries by places by points would take minutes.
TEST(Legend, StaysAsItIsDrawnInAFigureOfTooManyPoints) {
    const auto found = [](int points) {
        std::string body;
        for (int i = 0; i < 10; ++i) {
            const std::string y = std::to_string(5 + 9 * i),
                              colour = "stroke='#00" + std::to_string(10 + 5 * i) + "ff' fill='none'";
            body += "<path d='M150 " + y + " h12' " + colour + "/><text x='165' y='" + y + ".9' font-size='3'>Name " +
                    std::to_string(i) + "</text><path d='M10 " + y + " h90' " + colour + "/>";
        }
        body += "<path d='M10 1";
        for (int i = 0; i < points; ++i) body += i % 2 == 0 ? "l.1 .1" : "l-.1 -.1";
        return figure(body + "' fill='none' stroke='black'/>");
    };
    const auto told = [](const FoundPage& page) {
        return std::any_of(page.notes.begin(), page.notes.end(),
                           [](const Phrase& note) { return note.english().find("legend") != std::string::npos; });
    };
    const FoundPage small = found(100), large = found(200000);
    EXPECT_TRUE(told(small));
    EXPECT_FALSE(told(large));
    for (const FoundWords& words : large.words) EXPECT_FALSE(words.thing);
    EXPECT_EQ(large.page.strokes.size(), small.page.strokes.size() + 10);
}

TEST(Legend, NamesTheLargestOfSurfaces) {
    const FoundPage found = figure(
        "<rect x='20' y='50' width='20' height='40' fill='#1f77b4'/><rect x='60' y='30' width='20' height='60' fill='#1f77b4'/>"
        "<rect x='40' y='70' width='20' height='20' fill='#ff7f0e'/>"
        "<rect x='120' y='4' width='10' height='4' fill='#1f77b4'/><text x='133' y='7.5' font-size='4'>Men</text>"
        "<rect x='120' y='11' width='10' height='4' fill='#ff7f0e'/><text x='133' y='14.5' font-size='4'>Women</text>");
    EXPECT_EQ(found.page.strokes.size(), 3u);
    ASSERT_TRUE(words_named(found, "Men").thing);
    EXPECT_NEAR(words_named(found, "Men").thing->x, 70, 1e-6);
    EXPECT_NEAR(words_named(found, "Women").thing->x, 50, 1e-6);
}

// As ggplot2 has them, of "1999" and "2008" in 8.8 points.
TEST(Legend, HasBoxesThatAreHigherThanItsRows) {
    const FoundPage found = figure(
        "<rect x='20' y='50' width='20' height='40' fill='#f8766d'/><rect x='60' y='30' width='20' height='60' fill='#00bfc4'/>"
        "<rect x='120' y='10' width='17.3' height='17.3' fill='#f2f2f2'/><rect x='120.7' y='10.7' width='15.9' height='15.9' "
        "fill='#f8766d'/><rect x='120' y='27.3' width='17.3' height='17.3' fill='#f2f2f2'/><rect x='120.7' y='28' width='15.9' "
        "height='15.9' fill='#00bfc4'/><text x='142.8' y='21.6' font-size='8.8'>1999</text>"
        "<text x='142.8' y='38.9' font-size='8.8'>2008</text>");
    ASSERT_TRUE(words_named(found, "1999").thing);
    EXPECT_NEAR(words_named(found, "1999").thing->x, 30, 1e-6);
    EXPECT_NEAR(words_named(found, "2008").thing->x, 70, 1e-6);
}

// Three fields of two kinds, that lean, with samples; what is drawn last lies on the others.
std::string fields(std::string_view one, std::string_view other, std::string_view last) {
    const auto fill = [](std::string_view paint) { return " fill='" + std::string(paint) + "'/>"; };
    return "<path d='M20 50 L40 52 V90 H20 Z'" + fill(one) + "<path d='M60 30 L80 32 V90 H60 Z'" + fill(one) +
           "<path d='M40 60 L60 62 V90 H40 Z'" + fill(other) + std::string(last) + "<rect x='120' y='4' width='10' height='4'" +
           fill(one) + "<text x='133' y='7.5' font-size='4'>Men</text>" + "<rect x='120' y='11' width='10' height='4'" +
           fill(other) + "<text x='133' y='14.5' font-size='4'>Women</text>";
}

std::vector<int> textures_in(const FoundPage& found) {
    std::vector<int> textures;
    for (const Area& area : found.page.textured) textures.push_back(area.texture);
    return textures;
}

TEST(Legend, FillsWhatItTellsApartWithTextures) {
    const FoundPage found = figure(fields("#1f77b4", "#ff7f0e", ""));
    const std::vector<int> textures = textures_in(found);
    ASSERT_EQ(textures.size(), 3u);
    EXPECT_EQ(textures[0], textures[1]);
    EXPECT_NE(textures[0], textures[2]);
    EXPECT_GT(share_black(textures[0]), share_black(textures[2]));  // the darker colour
    ASSERT_EQ(found.page.textured[1].rings.size(), 1u);
    EXPECT_EQ(found.page.textured[1].rings[0].size(), 4u);
}

TEST(Legend, FillsPatternsByTheirNames) {
    const FoundPage found = figure(fields("url(#a)", "url(#b)", ""));
    const std::vector<int> textures = textures_in(found);
    ASSERT_EQ(textures.size(), 3u);
    EXPECT_EQ(textures[0], textures[1]);
    EXPECT_NE(textures[0], textures[2]);
}

// As in a page of a PDF, where each surface has a pattern of its own.
TEST(Legend, FillsPatternsByTheirContent) {
    std::string body = fields("url(#a)", "url(#b)", ""), defs;
    for (int i = 0; i < 3; ++i) {
        const std::string id = "a" + std::to_string(i);
        body.replace(body.find("#a)"), 2, "#" + id);
        defs += "<pattern id='" + id + "' width='8' height='8'><path d='M0 8 L8 0' stroke='black'/></pattern>";
    }
    const std::vector<int> textures = textures_in(figure("<defs>" + defs + "</defs>" + body));
    ASSERT_EQ(textures.size(), 3u);
    EXPECT_EQ(textures[0], textures[1]);
    EXPECT_NE(textures[0], textures[2]);
}

TEST(Legend, FillsNothingWhereSurfacesLieOnEachOther) {
    EXPECT_TRUE(
        textures_in(figure(fields("#1f77b4", "#ff7f0e", "<rect x='30' y='55' width='20' height='20' fill='#ff7f0e'/>"))).empty());
    EXPECT_EQ(
        textures_in(figure(fields("#1f77b4", "#ff7f0e", "<rect x='85' y='55' width='20' height='20' fill='#ff7f0e'/>"))).size(),
        4u);
}

// As black and whole as the axes and the ticks, it is known by its place in the legend and by the only curve that is so.
TEST(Legend, ASampleMayLookLikeAxes) {
    const std::string black = "' fill='none' stroke='black'", text = "<text font-size='4' ",
                      axes = "<path d='M20 10 V90 H180" + black + "/>",
                      ticks = "<path d='M16 70 h4" + black + "/>" + text + "x='10' y='71.5'>10</text><path d='M16 50 h4" + black +
                              "/>" + text + "x='10' y='51.5'>20</text>",
                      legend = "<path d='M120 10 h12" + black + "/>" + text + "x='136' y='11.5'>Oak</text><path d='M120 16 h12" +
                               black + " stroke-dasharray='4'/>" + text + "x='136' y='17.5'>Elm</text>",
                      dashed = "<path d='M20 80 L100 60 L180 70" + black + " stroke-dasharray='4'/>",
                      whole = "<path d='M20 30 L100 50 L180 40" + black + "/>";
    const FoundPage found = figure(axes + ticks + dashed + whole + legend);
    ASSERT_TRUE(words_named(found, "Oak").thing);
    EXPECT_NEAR(words_named(found, "Oak").thing->y, 40, 11);
    ASSERT_TRUE(words_named(found, "Elm").thing);
    EXPECT_FALSE(words_named(found, "10").thing);
    // Which of two it names nobody knows.
    const FoundPage two = figure(axes + ticks + dashed + whole + "<path d='M20 20 L100 25 L180 15" + black + "/>" + legend);
    EXPECT_FALSE(words_named(two, "Oak").thing);
}

// Long ticks beside numbers look like samples, but all alike.
TEST(Legend, TicksAreNoSamples) {
    std::string axis = "<path d='M30 10 V90 H180' fill='none' stroke='black'/>";
    for (const int y : {20, 40, 60, 80})
        axis += "<path d='M26 " + std::to_string(y) + " h4' stroke='black'/><text x='10' y='" + std::to_string(y + 1) +
                "' font-size='4'>" + std::to_string(y) + "</text>";
    const FoundPage found = figure(axis);
    EXPECT_EQ(found.page.strokes.size(), 5u);
    for (const FoundWords& words : found.words) EXPECT_FALSE(words.thing);
}

TEST(Words, TakeSizeAndAnchorFromTheGroup) {
    const FoundPage found = figure(
        "<g font-size='10' text-anchor='end'><text x='100' y='50'>Rain</text></g>"
        "<g style='font-size:5px'><text x='100' y='80'>Rain</text></g>");
    EXPECT_NEAR(found.words[0].middle.x, 100 - 11, 3);
    EXPECT_NEAR(found.words[1].middle.x, 100 + 5.5, 2);
}

// White rules of a table on black are no grid, as black ones on white are none.
TEST(Grid, IsJudgedOnItsGround) {
    std::string rules;
    for (const char* x : {"20", "60", "100", "140"}) rules += std::string("<path d='M") + x + " 20V180' stroke='white'/>";
    EXPECT_EQ(figure("<rect width='200' height='100' fill='black'/>" + rules).page.strokes.size(), 4u);
}

TEST(Ground, ItsBorderIsDrawn) {
    EXPECT_EQ(
        figure(
            "<rect width='200' height='100' fill='white' stroke='black' stroke-width='2'/><path d='M20 50H90' stroke='black'/>")
            .page.strokes.size(),
        2u);
}

// One thing beside one word is that thing.
TEST(Legend, HasTwoSamplesInLine) {
    const FoundPage pond = figure(
        "<path d='M20 20h60v40h-60z' fill='#66f'/><path d='M120 70h12v6h-12z' fill='#66f'/>"
        "<text x='136' y='76' font-size='5'>Mill pond</text><text x='30' y='40' font-size='5'>Great Lake</text>");
    EXPECT_EQ(pond.page.strokes.size(), 2u);
    for (const FoundWords& words : pond.words) EXPECT_FALSE(words.thing) << words.text;
}

// Observable Plot labels a group of texts, each of which says something else.
TEST(Words, OfAGroupWithALabelAreItsTexts) {
    const FoundPage found =
        figure("<g aria-label='x-axis tick label'><text x='20' y='50'>0</text><text x='60' y='50'>10</text></g>");
    ASSERT_EQ(found.words.size(), 2u);
    EXPECT_EQ(found.words[1].text, "10");
}

TEST(Words, SizesInEmCountOnce) {
    const auto middle = [](const std::string& size) {
        return figure("<g font-size='4'><text x='60' y='50' font-size='" + size + "'>Abcdefghij</text></g>").words.at(0).middle.x;
    };
    EXPECT_NEAR(middle("3em"), middle("12"), 1e-9);
    EXPECT_NEAR(middle("300%"), middle("12"), 1e-9);
}

TEST(Words, AToolsNameIsNoTitle) {
    const auto title = [](const std::string& body) { return figure(body).page.title; };
    EXPECT_EQ(title("<title>Gnuplot</title><desc>Produced by GNUPLOT 5.4 patchlevel 4 </desc>"), "");
    EXPECT_EQ(title("<title>Harvest</title><desc>Produced by GNUPLOT 5.4 patchlevel 4 </desc>"), "Harvest");
}

TEST(Words, FormulaeBecomePlainSigns) {
    EXPECT_EQ(without_markup("$CO_2$ in mg/m$^3$"), "CO2 in mg/m\u00b3");
    EXPECT_EQ(without_markup("$y = 1 - e^{-x}$"), "y = 1 \u2212 e^(\u2212x)");
    EXPECT_EQ(without_markup("$\\alpha_1 \\leq 0.5\\,\\%$"), "\u03b11 \u2264 0.5 %");
    EXPECT_EQ(without_markup("$x_{\\mathrm{max}}$"), "x_max");
    EXPECT_EQ(without_markup("$\\frac{a+b}{2}$"), "(a+b)/2");
    EXPECT_EQ(without_markup("20$^\\circ$C"), "20\u00b0C");
    for (const std::string stays : {"$\\unknown{x}$", "5 $", "$x^$", "$a}$", "$\\frac{a}$", "Cost in $\nGain in $"})
        EXPECT_EQ(without_markup(stays), stays);
    std::string deep = "$";
    for (int i = 0; i < 1'000'000; ++i) deep += "\\sqrt";
    EXPECT_EQ(without_markup(deep + "x$"), deep + "x$");
}

// Matplotlib has a comment for each line, in one group.
TEST(Words, OfSeveralLinesAreAllThere) {
    const FoundPage found = figure(
        "<g id='text_1'><!-- First line --><g><path d='M20 15 h24 v8 h-24 z'/></g><!-- and $x^2$ -->"
        "<g><path d='M20 27 h24 v8 h-24 z'/></g></g>");
    ASSERT_EQ(found.words.size(), 1u);
    EXPECT_EQ(found.words[0].text, "First line and x\u00b2");
    EXPECT_NEAR(found.words[0].height, 10, 1e-6);
}

// Matplotlib writes a formula's letters font by font, and what it says in a comment.
TEST(Words, FormulaeAsTextAreReadInTheirOrder) {
    const FoundPage found = figure(
        "<g id='text_1'><!-- $x_{max}$ = 5 --><g transform='translate(50 50)'><text>"
        "<tspan style='font: 10px x' x='0' y='0'>x</tspan><tspan style='font: 7px x' x='6' y='2'>max</tspan>"
        "<tspan style='font: 10px x' x='20' y='0'>=5</tspan></text></g></g>"
        "<g id='text_2'><!-- Two lines --><text><tspan x='5' y='80' font-size='4'>Two</tspan><tspan x='5' y='86' "
        "font-size='4'>lines</tspan></text></g>");
    ASSERT_EQ(found.words.size(), 3u);
    EXPECT_EQ(found.words[0].text, "x_max = 5");
    EXPECT_EQ(found.words[2].text, "lines");
}

}  // namespace
}  // namespace tactics::chart_parts_test
