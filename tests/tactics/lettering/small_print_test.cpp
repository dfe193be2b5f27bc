// SPDX-License-Identifier: Apache-2.0
// Print of few pixels, by its company.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "tactics/lettering/read_line.h"

namespace tactics::small_print_test {
namespace {

using Rows = std::vector<std::string_view>;

const Rows kTwo{" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"},
    kFour{"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "},
    kSeven{"#####", "    #", "   # ", "   # ", "  #  ", "  #  ", "  #  "}, kOne{" # ", "## ", " # ", " # ", " # ", " # ", "###"},
    kN{"# ## ", "##  #", "#   #", "#   #", "#   #"}, kE{" ### ", "#   #", "#####", "#    ", " ####"},
    kW{"#   #", "#   #", "# # #", "# # #", " # # "},
    kRing{"  ###  ", " #   # ", "#     #", "#     #", "#     #", " #   # ", "  ###  "},
    kDot{" ### ", "#####", "#####", "#####", " ### "};

class SmallLines : public ::testing::Test {
protected:
    // A pixel for each sign.
    void draw(int left, int top, const Rows& rows) {
        for (std::size_t y = 0; y < rows.size(); ++y)
            for (std::size_t x = 0; x < rows[y].size(); ++x)
                if (rows[y][x] == '#') picture.row(top + static_cast<int>(y))[left + static_cast<int>(x)] = 0;
    }
    void write(int left, int top, const std::vector<Rows>& letters) {
        for (const Rows& letter : letters) {
            draw(left, top + 7 - static_cast<int>(letter.size()), letter);
            left += static_cast<int>(letter.front().size()) + 2;
        }
    }
    SmallPrint at(int x, int y) const {
        std::vector<ReadLine> lines;
        std::vector<LetteringLine> found_lines, low;
        found_lines = find_lettering(picture, nullptr, &low);
        add_low_print(picture, found_lines, std::move(low));
        for (LetteringLine& line : found_lines) {
            ReadLine one{std::move(line), {}};
            one.words.sure =
                std::any_of(read.begin(), read.end(), [&](const PixelBox& box) { return overlap(box, one.line.box); });
            lines.push_back(std::move(one));
        }
        const std::vector<SmallPrint> found = small_print(picture, lines);
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (const PixelBox& box = lines[i].line.box; x >= box.left && x < box.right && y >= box.top && y < box.bottom)
                return found[i];
        return SmallPrint::none;
    }
    // Two words that were read.
    void know() {
        write(20, 20, {kTwo, kFour, kSeven}), write(20, 60, {kFour, kTwo, kSeven});
        read = {{20, 20, 40, 27}, {20, 60, 40, 67}};
    }

    Image picture = make_image(300, 200, 1, 0, 255);
    std::vector<PixelBox> read;
};

TEST_F(SmallLines, WordsWithoutTallLettersAreFoundBesideOthers) {
    write(20, 100, {kN, kE, kW});
    EXPECT_EQ(find_lettering(picture).size(), 0u) << "by itself it may be anything";
    know();
    EXPECT_EQ(at(22, 104), SmallPrint::out);
    write(150, 137, {kN, kE, kW});
    EXPECT_EQ(at(152, 141), SmallPrint::none) << "in line with nothing, and nobody has read it";
    write(20, 150, {kDot, kDot, kDot});
    EXPECT_EQ(at(22, 155), SmallPrint::none) << "dots";
}

TEST_F(SmallLines, WordsWithoutTallLettersMayClimb) {
    know();
    Image level = make_image(40, 20, 1, 0, 255);
    std::swap(level, picture);
    write(4, 4, {kN, kE, kW, kE});
    std::swap(level, picture);
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x)
            if (level.row(y)[x] == 0) picture.row(180 - x)[100 + y] = 0;
    std::vector<LetteringLine> low, lines = find_lettering(picture, nullptr, &low);
    add_low_print(picture, lines, std::move(low));
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                            [](const LetteringLine& one) { return one.upwards && one.letters.size() == 4; }),
              1);
}

TEST_F(SmallLines, WhatIsThickerThanPrintIsNone) {
    know();
    Rows thick;
    for (const std::string_view row :
         {"###   ###", "####  ###", "######### ", "#########", "###  ####", "###   ###", "###   ###"})
        thick.push_back(row);
    write(20, 100, {thick, thick});
    EXPECT_EQ(at(22, 103), SmallPrint::none);
}

TEST_F(SmallLines, FiguresInStepsAreThoseOfAnAxis) {
    know();
    draw(60, 150, kOne), draw(119, 150, kTwo), draw(179, 150, kSeven), draw(239, 150, kFour);
    EXPECT_EQ(at(120, 151), SmallPrint::out);
    EXPECT_EQ(at(240, 152), SmallPrint::out);
    draw(90, 180, kSeven);  // of no step
    EXPECT_EQ(at(92, 181), SmallPrint::none);
}

// Ticks of an axis are in steps, too; an axis that blends with bars is paler than they are.
TEST_F(SmallLines, TicksOnAPaleAxisAreNone) {
    know();
    for (int x = 40; x < 260; ++x) picture.row(149)[x] = picture.row(148)[x] = picture.row(147)[x] = 140;
    for (const int x : {60, 120, 180, 240})
        for (int y = 150; y < 157; ++y) picture.row(y)[x] = 0;
    EXPECT_EQ(at(120, 152), SmallPrint::none);
    for (int x = 40; x < 260; ++x) picture.row(149)[x] = picture.row(148)[x] = picture.row(147)[x] = 255;
    EXPECT_EQ(at(120, 152), SmallPrint::out) << "a row of ones";
}

// As ggplot2 draws them: the axis has no line, and its plot a pale ground.
TEST_F(SmallLines, TicksBelowAPalePanelAreNone) {
    for (const std::uint8_t ground : {std::uint8_t{235}, std::uint8_t{255}}) {
        know();
        for (int y = 90; y < 150; ++y) std::fill_n(picture.row(y) + 40, 220, ground);
        for (const int x : {60, 120, 180, 240})
            for (int y = 150; y < 157; ++y) picture.row(y)[x] = 0;
        EXPECT_EQ(at(120, 152), ground < 255 ? SmallPrint::none : SmallPrint::out) << int{ground};
    }
}

TEST_F(SmallLines, MarksOfAPlotAreNone) {
    know();
    for (const int x : {90, 131, 168, 215, 240, 262}) draw(x, 30 + x / 3, kRing);
    draw(150, 100, kRing), draw(154, 103, kRing);  // one covers the other
    draw(190, 60, kRing), draw(199, 60, kRing);    // side by side they look like a word
    for (const Point p : {Point{93, 60}, Point{150, 103}, Point{190, 63}}) {
        const SmallPrint found = at(static_cast<int>(p.x), static_cast<int>(p.y));
        EXPECT_TRUE(found == SmallPrint::none || found == SmallPrint::mark) << p.x;
    }
    EXPECT_EQ(at(190, 63), SmallPrint::mark);
}

}  // namespace
}  // namespace tactics::small_print_test
