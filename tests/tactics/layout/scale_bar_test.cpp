// SPDX-License-Identifier: Apache-2.0
// To scale: the drawing has the size that was asked for, and the bar says so.
#include "tactics/layout/scale_bar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "print/format.h"
#include "tactics/description/description.h"
#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/room.h"
#include "tactics/layout/title.h"
#include "tactics/rules/rule.h"
#include "tests/print/brf_reader.h"

namespace tactics::scale_bar_test {
namespace {

Sheet sheet_on(std::string_view paper, std::string_view medium, double real_width) {
    Sheet sheet;
    sheet.paper = find_paper(paper, "test");
    sheet.medium = &find_medium(medium, "test");
    sheet.title = "A house";
    sheet.real_width = real_width;
    return sheet;
}

Drawing box(double width, double height) {
    return {width, height, {Stroke{{{0, 0}, {width, 0}, {width, height}, {0, height}}, true}}, {}, {}};
}

std::string message_of(const Sheet& sheet, const Drawing& drawing) {
    try {
        lay_out(drawing, sheet);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::usage);
        return error.what();
    }
    return "no error";
}

// The drawn length divided by the stated one, for any paper, medium and size of the thing.
TEST(ScaleBar, IsAsLongAsItSays) {
    for (const char* paper : {"a4", "a5", "11x11.5", "120x150mm"})
        for (const char* medium : {"swell", "embosser", "thermoform"})
            for (const double real : {3e-2, 7.0, 450.0, 12e3, 1.3e6, 9.9e9}) {
                const Sheet sheet = sheet_on(paper, medium, real);
                const Page page = lay_out(box(200, 130), sheet);
                ASSERT_TRUE(page.scale) << paper << ' ' << medium << ' ' << real;
                const double drawn = page.strokes[0].points[1].x - page.strokes[0].points[0].x;
                EXPECT_NEAR(page.scale->length / page.scale->real, drawn / real, kPageStep * 1e-2 * drawn / real);
                EXPECT_GE(page.scale->length, 12.7);
                EXPECT_LE(page.scale->length, 60 + 1e-9);
                const double leading = page.scale->real / std::pow(10, std::floor(std::log10(page.scale->real) + 1e-9));
                EXPECT_TRUE(std::abs(leading - 1) < 1e-6 || std::abs(leading - 2) < 1e-6 || std::abs(leading - 5) < 1e-6)
                    << leading;
                // What is drawn is the bar and two marks, as long as is said.
                std::vector<const PageStroke*> bar;
                for (const PageStroke& stroke : page.strokes)
                    if (stroke.role == Role::scale) bar.push_back(&stroke);
                ASSERT_EQ(bar.size(), 3u);
                EXPECT_NEAR(distance(bar[0]->points[0], bar[0]->points[1]), page.scale->length, kPageStep);
                EXPECT_EQ(bar[1]->points[0].x, bar[0]->points[0].x);
                EXPECT_EQ(bar[2]->points[0].x, bar[0]->points[1].x);
            }
}

TEST(ScaleBar, BrailleIsLevelWithTheBar) {
    for (const bool print : {true, false}) {
        Sheet sheet = sheet_on("a4", "swell", 12e3);
        sheet.title.clear();
        sheet.print_title = print;
        const Page page = lay_out(box(200, 130), sheet);
        const Rect words = extent_of(page.braille.at(0), page.cell, page.braille_dot);
        EXPECT_NEAR(words.middle().y, page.strokes.at(1).points[0].y, 1e-9);
        EXPECT_NEAR(words.left - page.strokes[1].points[1].x - page.strokes[1].width / 2, 6, kPageStep);
    }
}

// A bar in dots with marks no higher than a cell reads as a line of braille: there are dots above it and below it.
TEST(ScaleBar, IsNotTakenForBraille) {
    for (const double height : {130.0, 133.0, 136.0, 139.0}) {
        Sheet sheet = sheet_on("11x11.5", "embosser", 12e3);
        sheet.margin = 6 + (height - 130) / 3;
        Page page = lay_out(box(200, height), sheet);
        std::erase_if(page.strokes, [](const PageStroke& stroke) { return stroke.role != Role::scale; });
        page.braille.clear();
        const Format& brf = *find_format("brf");
        std::map<double, int> rows;
        const auto read = test::read_brf(brf.encode(page, Settings(brf.options)));
        for (const test::BrfDot& dot : read.at(0).dots) ++rows[dot.y];
        const auto bar =
            std::max_element(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
        ASSERT_NE(bar, rows.end());
        EXPECT_NE(bar, rows.begin()) << "nothing above";
        EXPECT_NE(bar, std::prev(rows.end())) << "nothing below";
        EXPECT_GT(rows.rbegin()->first - rows.begin()->first, 2 * page.cell.dot_pitch);
    }
}

TEST(ScaleBar, WordsAreShort) {
    EXPECT_EQ(real_length(1000).english(), "1 m");
    EXPECT_EQ(real_length(999.9999999).english(), "1 m");
    EXPECT_EQ(real_length(250).english(), "25 cm");
    EXPECT_EQ(real_length(2).english(), "2 mm");
    EXPECT_EQ(real_length(0.05).english(), "0.05 mm");
    EXPECT_EQ(real_length(2.5e6).english(), "2.5 km");
    EXPECT_EQ(real_length(123456).english(), "123 m");
    EXPECT_EQ(real_length(5e9).english(), "5000 km");
}

// No rule that a page must keep is broken by it, and it stands clear of the drawing.
TEST(ScaleBar, StandsClearOfTheDrawing) {
    for (const char* medium : {"swell", "thermoform"})
        for (const double height : {30.0, 130.0, 500.0}) {
            const Sheet sheet = sheet_on("a4", medium, 12e3);
            const Page page = lay_out(box(200, height), sheet);
            for (const Verdict& verdict : check_page(page, demands_of(*sheet.medium)))
                EXPECT_TRUE(verdict.findings.places.empty())
                    << verdict.demand.rule->name << ": " << verdict.findings.places[0].message.english();
            const Rect& bar = page.scale->place;
            EXPECT_GE(bar.left, page.live.left - 1e-9);
            EXPECT_LE(bar.top + bar.height, page.live.top + page.live.height + 1e-9);
        }
}

TEST(Scale, GivesTheDrawingItsSize) {
    for (const double ratio : {50.0, 100.0, 333.0}) {
        Sheet sheet = sheet_on("a4", "swell", 9000);
        sheet.scale = 1 / ratio;
        const Page page = lay_out(box(200, 130), sheet);
        EXPECT_NEAR(page.strokes[0].points[1].x - page.strokes[0].points[0].x, 9000 / ratio, kPageStep);
        EXPECT_NEAR(page.scale->length / page.scale->real, 1 / ratio, 1e-9);
    }
}

// What the message offers is accepted.
TEST(Scale, ThatDoesNotFitIsToldWithWhatWould) {
    Sheet sheet = sheet_on("a4", "swell", 12e3);
    sheet.scale = 1.0 / 40;
    const Drawing drawing = box(200, 130);
    const std::string message = message_of(sheet, drawing);
    EXPECT_EQ(
        message,
        "--scale: at this scale the drawing would be 300 mm wide and 195 mm high, and the page has room for 210.8 mm x 137 mm; "
        "take --scale 1:57, or --paper 11x17, or --tiles 2x2");
    Sheet other = sheet;
    other.scale = 1.0 / 57;
    EXPECT_EQ(message_of(other, drawing), "no error");
    other = sheet;
    other.paper = find_paper("11x17", "test");
    EXPECT_EQ(message_of(other, drawing), "no error");
    other = sheet;
    other.tiles = {2, 2};
    EXPECT_EQ(message_of(other, drawing), "no error");
    sheet.scale = 1e-5;
    EXPECT_EQ(message_of(sheet, drawing),
              "--scale: at this scale the drawing would be 0.12 mm wide, too little to be felt; take --scale 1:57");
    // So large that nothing would do but another scale.
    sheet.scale = 10;
    EXPECT_NE(message_of(sheet, drawing).find("; take --scale 1:57"), std::string::npos);
    EXPECT_EQ(message_of(sheet, drawing).find("--tiles"), std::string::npos);
}

TEST(ScaleBar, StandsOnOneSheetOfALargePage) {
    Sheet sheet = sheet_on("a5", "swell", 40e3);
    sheet.tiles = {2, 2};
    const Pages pages = pages_of(box(200, 130), sheet);
    std::size_t with = 0;
    for (const Page& page : pages.all) {
        if (!page.scale) continue;
        ++with;
        std::size_t strokes = 0, words = 0;
        for (const PageStroke& stroke : page.strokes) strokes += stroke.role == Role::scale ? 1 : 0;
        for (const PrintLine& line : page.print) words += line.text == page.scale->text ? 1 : 0;
        EXPECT_EQ(strokes, 3u);
        EXPECT_EQ(words, 1u);
    }
    EXPECT_EQ(with, 1u);
    EXPECT_TRUE(pages.all[2].scale) << "the first of the lower row";
}

TEST(ScaleBar, IsTold) {
    Sheet sheet = sheet_on("a4", "swell", 12e3);
    sheet.scale = 1.0 / 100;
    const std::vector<std::string> lines = lines_of(describe(lay_out(box(200, 130), sheet)));
    EXPECT_NE(std::find(lines.begin(), lines.end(),
                        "The scale bar in the lower left, 5 cm long, stands for 5 m: 1 cm on the page is 1 m."),
              lines.end())
        << lines[3];
    EXPECT_NE(std::find(lines.begin(), lines.end(), "On it: 1 line, 40 cm long."), lines.end())
        << "the bar is not counted as drawn: " << lines[2];
}

}  // namespace
}  // namespace tactics::scale_bar_test
