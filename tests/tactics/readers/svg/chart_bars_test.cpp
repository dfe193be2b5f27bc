// SPDX-License-Identifier: Apache-2.0
// Bars of charts in SVG: found by where they stand, told apart by their fills, named by their legend.
#include "tactics/readers/svg/chart_bars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tactics/readers/svg/figure.h"
#include "tests/tactics/readers/svg/figures.h"

namespace tactics::chart_bars_test {
namespace {

using tests::figure;

std::string rectangle(double x, double y, double width, double height, const std::string& paint) {
    std::ostringstream text;
    text << "<rect x='" << x << "' y='" << y << "' width='" << width << "' height='" << height << "' " << paint << "/>";
    return text.str();
}

std::string line(double x, double y, double to_x, double to_y) {
    std::ostringstream text;
    text << "<path d='M" << x << ' ' << y << " L" << to_x << ' ' << to_y << "' stroke='black' stroke-width='0.5' fill='none'/>";
    return text.str();
}

constexpr double kHeights[] = {50, 30, 60, 20, 40, 45};
constexpr double kWide = 8;

// Pairs that touch, on y = 90.
std::string pairs(const std::string& first, const std::string& second) {
    std::string text;
    for (int i = 0; i < 6; ++i)
        text += rectangle(30 + 25 * (i / 2) + kWide * (i % 2), 90 - kHeights[i], kWide, kHeights[i], i % 2 == 0 ? first : second);
    return text;
}

const std::string kAxis = line(20, 90, 180, 90), kRed = "fill='#d62728'", kPale = "fill='#aec7e8' stroke='black'";

std::size_t rungs_of(const FoundPage& chart) {
    const Drawing drawing = drawing_of_figure(chart, 200);
    return static_cast<std::size_t>(std::count_if(drawing.strokes.begin(), drawing.strokes.end(), [](const Stroke& stroke) {
        return stroke.points.size() == 2 && stroke.points[0].y == stroke.points[1].y && stroke.points[0].y < 89 &&
               std::abs(distance(stroke.points[0], stroke.points[1]) - kWide) < 1;
    }));
}

TEST(ChartBars, OfTwoColoursAreToldApartByRungs) {
    const FoundPage chart = figure(kAxis + pairs(kRed, kPale));
    ASSERT_TRUE(chart.bars);
    EXPECT_EQ(chart.bars->bars.size(), 6u);
    ASSERT_EQ(chart.bars->looks.size(), 2u);
    EXPECT_GT(chart.bars->looks[0].dark, chart.bars->looks[1].dark);
    EXPECT_TRUE(chart.bars->on_axis);
    EXPECT_FALSE(chart.bars->lying);
    EXPECT_NEAR(chart.bars->base, 90, 0.01);
    // In the red ones, 4.6 mm apart and so far from their ends; besides, the six ends, of which that of a pair is one where they
    // meet.
    EXPECT_GT(rungs_of(chart), 6u + 20);
    EXPECT_LE(rungs_of(figure(kAxis + pairs(kRed, kRed))), 6u);
}

TEST(ChartBars, MayLieHangOrStandOnEachOther) {
    std::string lying, hanging, stacked;
    for (int i = 0; i < 4; ++i) {
        lying += rectangle(40, 10 + 20 * i, 30 + 25 * (i % 3), 10, kRed);
        hanging += rectangle(30 + 30 * i, i % 2 == 0 ? 20 : 50, 15, i % 2 == 0 ? 30 : 20 + 5 * i, kRed);
        stacked +=
            rectangle(30 + 30 * i, 60, 15, 30, kRed) + rectangle(30 + 30 * i, 60 - kHeights[i] / 2, 15, kHeights[i] / 2, kPale);
    }
    const FoundPage level = figure(lying);
    ASSERT_TRUE(level.bars);
    EXPECT_TRUE(level.bars->lying);
    EXPECT_FALSE(level.bars->on_axis);
    EXPECT_NEAR(level.bars->base, 40, 0.01);
    const FoundPage below = figure(line(20, 50, 180, 50) + hanging + rectangle(150, 25, 15, 25, kRed));
    ASSERT_TRUE(below.bars);
    EXPECT_EQ(below.bars->bars.size(), 5u);
    const FoundPage on = figure(kAxis + stacked);
    ASSERT_TRUE(on.bars);
    EXPECT_EQ(on.bars->bars.size(), 8u);
    EXPECT_EQ(on.bars->looks.size(), 2u);
}

// The surface, and the line around it that is drawn for itself, as gnuplot does.
TEST(ChartBars, AreOneWithTheirOutlines) {
    const FoundPage chart =
        figure(kAxis + pairs(kRed, kPale) + pairs("fill='none' stroke='black'", "fill='none' stroke='black'"));
    ASSERT_TRUE(chart.bars);
    EXPECT_EQ(chart.bars->bars.size(), 6u);
    EXPECT_EQ(chart.bars->looks.size(), 2u);
    EXPECT_EQ(drawing_of_figure(chart, 200).strokes.size(),
              drawing_of_figure(figure(kAxis + pairs(kRed, kPale)), 200).strokes.size());
}

// As R draws them: lines from side to side, and then the outline.
std::string hatched(double x, double height, bool rising) {
    std::string text;
    for (double off = 3 - kWide; off < height; off += 4) {  // lines at 45 degrees, cut at the sides
        const double low = std::max(off, 0.0), high = std::min(off + kWide, height);
        const double from = low - off, to = high - off;
        text +=
            rising ? line(x + from, 90 - low, x + to, 90 - high) : line(x + kWide - from, 90 - low, x + kWide - to, 90 - high);
    }
    return text + rectangle(x, 90 - height, kWide, height, "fill='none' stroke='black'");
}

TEST(ChartBars, AreToldApartByHatchesOfLines) {
    std::string body = kAxis;
    for (int i = 0; i < 6; ++i) body += hatched(30 + 25 * (i / 2) + kWide * (i % 2), kHeights[i], i % 2 == 0);
    const FoundPage chart = figure(body);
    ASSERT_TRUE(chart.bars);
    EXPECT_EQ(chart.bars->bars.size(), 6u);
    EXPECT_EQ(chart.bars->looks.size(), 2u);
    for (const ChartBar& bar : chart.bars->bars)
        EXPECT_EQ(bar.look, bar.box.left == 30 || bar.box.left == 55 || bar.box.left == 80 ? 0u : 1u);
    const Drawing drawing = drawing_of_figure(chart, 200);
    for (const Stroke& stroke : drawing.strokes)
        for (std::size_t i = 1; i < stroke.points.size(); ++i)
            EXPECT_TRUE(stroke.points[i].x == stroke.points[i - 1].x || stroke.points[i].y == stroke.points[i - 1].y)
                << "a line of the hatch is left";
}

// The level lines of a small sample look like samples of lines.
TEST(ChartBars, OfLevelAndRisingLinesAreNamedByTheirSamples) {
    const auto level = [](double x, double y, double wide, double high) {
        std::string text;
        for (double off = 1.2; off < high; off += 1.2) text += line(x, y + off, x + wide, y + off);
        return text + rectangle(x, y, wide, high, "fill='none' stroke='black'");
    };
    const auto rising = [](double x, double y) {  // a sample, with its corners cut
        return line(x, y + 2, x + 2, y) + line(x + 1, y + 4, x + 4, y + 1) + line(x + 3, y + 4, x + 4, y + 3) +
               rectangle(x, y, 4, 4, "fill='none' stroke='black'");
    };
    std::string body = kAxis;
    for (int i = 0; i < 6; ++i)
        body += i % 2 == 0 ? level(30 + 25 * (i / 2), 90 - kHeights[i], kWide, kHeights[i])
                           : hatched(30 + 25 * (i / 2) + kWide, kHeights[i], true);
    const FoundPage chart = figure(body + level(140, 8, 4, 4) + "<text font-size='4' x='147' y='11.5'>Boys</text>" +
                                   rising(140, 15) + "<text font-size='4' x='147' y='18.5'>Girls</text>");
    ASSERT_TRUE(chart.bars);
    for (const FoundWords& words : chart.words) {
        ASSERT_TRUE(words.thing) << words.text;
        const auto at = std::find_if(chart.bars->bars.begin(), chart.bars->bars.end(),
                                     [&](const ChartBar& bar) { return grown(bar.box, 0.1).holds(*words.thing); });
        ASSERT_NE(at, chart.bars->bars.end()) << words.text;
        EXPECT_EQ(at->look, words.text == "Boys" ? 0u : 1u) << words.text;
    }
}

// A frame with the lines of a grid from side to side is none.
TEST(ChartBars, FramesWithLinesAreNoHatches) {
    std::string body;
    for (const double left : {20.0, 110.0}) {
        body += rectangle(left, 10, 80, 80, "fill='none' stroke='black'");
        for (int i = 1; i < 8; ++i) body += line(left, 10 + 10 * i, left + 80, 10 + 10 * i);
    }
    const FoundPage chart = figure(body);
    EXPECT_FALSE(chart.bars);
    EXPECT_EQ(chart.page.strokes.size(), 16u);
}

TEST(ChartBars, BoxesTablesAndWhatLiesOnEachOtherAreNone) {
    std::string boxes, table, over;
    for (int i = 0; i < 4; ++i) {
        boxes += rectangle(20 + 40 * i, 40, 25, 15, kRed);
        for (int j = 0; j < 3; ++j) table += rectangle(20 + 20 * i, 20 + 20 * j, 20, 20, (i + j) % 2 == 0 ? kRed : kPale);
        over += rectangle(30 + 30 * i, 90 - kHeights[i], 15, kHeights[i], kRed) +
                rectangle(35 + 30 * i, 90 - kHeights[i + 1], 15, kHeights[i + 1], kPale);
    }
    EXPECT_FALSE(figure(boxes).bars);
    EXPECT_FALSE(figure(table).bars);
    EXPECT_FALSE(figure(over).bars);
}

// Too thin for a finger, and no room: as they are drawn.
TEST(ChartBars, ThatAFingerCannotFeelStayAsTheyAre) {
    std::string body = kAxis;
    for (int i = 0; i < 60; ++i)
        body += rectangle(30 + 2 * i, 90 - kHeights[i % 6], 2, kHeights[i % 6], i % 2 == 0 ? kRed : kPale);
    const FoundPage chart = figure(body);
    ASSERT_TRUE(chart.bars);
    EXPECT_EQ(drawing_of_figure(chart, 200).strokes.size(), 61u);
}

// In a row a sample may be nearer to the words before it; and the frame of the chart is none of the legend.
TEST(ChartBars, AreNamedByALegendInARow) {
    const std::string text = "<text font-size='5' ";
    const FoundPage chart =
        figure(rectangle(20, 5, 160, 85, "fill='none' stroke='black'") + pairs(kRed, kPale) + rectangle(60, 8, 8, 5, kRed) +
               text + "x='76' y='12'>Rain</text>" + rectangle(91, 8, 8, 5, kPale) + text + "x='107' y='12'>Snow</text>");
    ASSERT_TRUE(chart.bars);
    ASSERT_EQ(chart.words.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_TRUE(chart.words[i].thing);
        const auto named = std::find_if(chart.bars->bars.begin(), chart.bars->bars.end(),
                                        [&](const ChartBar& bar) { return grown(bar.box, 0.1).holds(*chart.words[i].thing); });
        ASSERT_NE(named, chart.bars->bars.end());
        EXPECT_EQ(chart.bars->looks[named->look].dark > 0.4, chart.words[i].text == "Rain") << chart.words[i].text;
    }
    EXPECT_TRUE(std::any_of(chart.page.strokes.begin(), chart.page.strokes.end(), [](const PageStroke& stroke) {
        return stroke.closed && box_of(stroke.points).width() > 150;
    })) << "the frame";
}

}  // namespace
}  // namespace tactics::chart_bars_test
