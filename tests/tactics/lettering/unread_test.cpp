// SPDX-License-Identifier: Apache-2.0
// Print that no reader made out is told, and marks of a plot are not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "tactics/lettering/read_line.h"

namespace tactics::unread_test {
namespace {

class UnreadPrint : public ::testing::Test {
protected:
    // Rows of a letter or mark; each sign is 2 pixels wide and high.
    void draw(int left, int top, const std::vector<std::string_view>& rows) {
        for (std::size_t y = 0; y < 2 * rows.size(); ++y)
            for (std::size_t x = 0; x < 2 * rows[y / 2].size(); ++x)
                if (rows[y / 2][x / 2] == '#') picture.row(top + static_cast<int>(y))[left + static_cast<int>(x)] = 0;
    }
    void disc(double x, double y, double inner, double outer) {
        for (int v = 0; v < picture.height; ++v)
            for (int u = 0; u < picture.width; ++u)
                if (const double r = std::hypot(u + 0.5 - x, v + 0.5 - y); r >= inner && r <= outer) picture.row(v)[u] = 0;
    }
    // Lines of several letters are read, or none; the last one only as `half` says.
    std::vector<PixelBox> told(bool some_are_read, const std::vector<std::string>& half = {}, const std::string& said = {}) {
        std::vector<ReadLine> lines;
        std::vector<LetteringLine> found = find_lettering(picture);
        for (LetteringLine& line : found) {
            ReadLine one{std::move(line), {}};
            const bool last = &line == &found.back() && (!half.empty() || !said.empty());
            one.words.sure = some_are_read && is_words(one.line) && !last;
            if (last) one.readings = half;
            if (last && !said.empty()) one.words = print_of(picture, one.line), one.words.text = said, one.words.sureness = 95;
            lines.push_back(std::move(one));
        }
        const std::vector<bool> unread = unread_print(picture, lines);
        std::vector<PixelBox> boxes;
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (unread[i]) boxes.push_back(lines[i].line.box);
        return boxes;
    }
    static bool has(const std::vector<PixelBox>& boxes, int x, int y) {
        return std::any_of(boxes.begin(), boxes.end(),
                           [&](const PixelBox& box) { return x >= box.left && x < box.right && y >= box.top && y < box.bottom; });
    }

    const std::vector<std::string_view> two{"#####", "    #", "    #", "#####", "#    ", "#    ", "#####"},
        four{"#   #", "#   #", "#   #", "#####", "    #", "    #", "    #"}, dash{"#####", "#####"};
    Image picture = make_image(300, 200, 1, 0, 255);
};

TEST_F(UnreadPrint, ASingleFigureIsToldAndMarksAreNot) {
    draw(20, 150, two), draw(34, 150, four);               // "24", which was read
    draw(100, 150, two);                                   // at the same axis
    draw(250, 60, four);                                   // alone
    for (const int x : {60, 130, 200}) disc(x, 40, 5, 7);  // circles of a plot
    disc(230, 110, 0, 7);
    draw(160, 100, dash);
    const auto boxes = told(true);
    EXPECT_EQ(boxes.size(), 2u);
    EXPECT_TRUE(has(boxes, 101, 151));
    EXPECT_TRUE(has(boxes, 251, 61));
}

TEST_F(UnreadPrint, WhereNoPrintIsKnownFewThingsAreTold) {
    draw(100, 150, two), draw(250, 60, four), disc(60, 40, 0, 7);
    EXPECT_EQ(told(false).size(), 2u);
    for (int i = 0; i < 9; ++i) draw(20 + 30 * i, 180, i % 2 == 0 ? two : four);
    EXPECT_TRUE(told(false).empty());
}

TEST_F(UnreadPrint, ABentDashAndMarksOfAboutOneSizeAreNone) {
    draw(20, 150, two), draw(34, 150, four);
    draw(130, 60, {"  ##  ", " #  # ", "#    #"});                                                 // a dash at the top of a curve
    draw(120, 66, {" #", " #", " #", "# ", "# "}), draw(145, 66, {"# ", "# ", " #", " #", " #"});  // and those beside it
    draw(264, 34, {"# ", "# ", "# ", " #", " #"}), draw(240, 6, {"##", "##", "##", "##", "##"}),
        draw(114, 82, {" #", " #", " #", "# ", "# "});
    draw(250, 20, {"###   ", "  ##  ", "   ## ", "    # ", "    ##"});
    draw(60, 20, {"#     #", " #   # ", "  # #  ", "   #   ", "  # #  ", " #   # ", "#     #"});
    draw(100, 30, {"   #   ", "   #   ", "   #   ", "#######", "   #   ", "   #   ", "   #   "});
    draw(200, 90, {"#######", "#     #", "#     #", "#     #", "#     #", "#     #", "#######"});
    draw(250, 100, four);  // alone
    const auto boxes = told(true);
    EXPECT_EQ(boxes.size(), 1u);
    EXPECT_TRUE(has(boxes, 251, 101));
}

TEST_F(UnreadPrint, MarksThatCoverEachOtherAreNone) {
    draw(20, 150, two), draw(34, 150, four);
    const std::vector<std::string_view> cross{"   #   ", "   #   ", "   #   ", "#######", "   #   ", "   #   ", "   #   "};
    for (const int x : {80, 140, 200, 260}) draw(x, 30 + x / 5, cross);
    draw(120, 100, cross), draw(122, 104, cross);  // as one piece they look like nothing else
    draw(180, 120, four);
    const auto boxes = told(true);
    EXPECT_EQ(boxes.size(), 1u);
    EXPECT_TRUE(has(boxes, 181, 121));
}

TEST_F(UnreadPrint, FiguresOfAnAxisAreToldWhereNoneOfThemWasRead) {
    draw(20, 20, two), draw(34, 20, four);  // "24", far away
    const std::vector<std::string_view> one{"  #", "###", "  #", "  #", "  #", "  #", "  #"},
        seven{"#####", "    #", "    #", "   # ", "   # ", "  #  ", "  #  "};
    draw(60, 150, one), draw(119, 151, two), draw(179, 152, seven), draw(239, 153, four);  // a scan is not quite level
    EXPECT_EQ(told(true).size(), 4u);
    draw(60, 100, {"#####", "#####", "#####", "#####", "#####", "#####", "#####"});
    EXPECT_EQ(told(true).size(), 4u);
}

TEST_F(UnreadPrint, ThreeStepsOfWhichOneIsKnownAreAnAxis) {
    const std::vector<std::string_view> one{"  #", "###", "  #", "  #", "  #", "  #", "  #"},
        seven{"#####", "    #", "    #", "   # ", "   # ", "  #  ", "  #  "};
    // Dashes and marks all over the picture, among which these would be dashes that bend.
    for (const int x : {10, 280}) draw(x, 10, {"# ", "# ", "# ", " #", " #"}), draw(x, 180, {"# ", "# ", " #", " #", " #"});
    draw(20, 60, two), draw(34, 60, four);     // "24", which was read
    draw(128, 63, one), draw(228, 66, seven);  // a scan is not quite level
    const auto in_steps = told(true);
    EXPECT_TRUE(has(in_steps, 132, 66));
    EXPECT_TRUE(has(in_steps, 229, 67));
    draw(74, 130, seven);  // of no step
    EXPECT_FALSE(has(told(true), 75, 131));
}

TEST_F(UnreadPrint, AFigureBesideAllThatIsDrawnIsNoDash) {
    draw(20, 20, two), draw(34, 20, four);
    const std::vector<std::string_view> seven{"#####", "    #", "    #", "   # ", "   # ", "  #  ", "  #  "};
    for (const int x : {100, 160, 220}) draw(x, 60 + x / 4, {"# ", "# ", "# ", " #", " #"});
    draw(152, 170, seven);
    EXPECT_TRUE(has(told(true), 153, 171));
    draw(152, 84, seven);  // among them
    EXPECT_FALSE(has(told(true), 153, 85));
}

TEST_F(UnreadPrint, FiguresThatClimbAreToldThoughTheyLieOnTheirSide) {
    draw(200, 150, two), draw(214, 150, four);  // "24", far away
    const std::vector<std::string_view> one{" #     ", "#######", "#######", "      #"},
        zero{"#######", "#     #", "#     #", "#######"};
    draw(20, 20, one), draw(20, 80, zero), draw(21, 140, one);  // 1, 0 and -1 of an upright axis
    EXPECT_EQ(told(true).size(), 3u);
}

TEST_F(UnreadPrint, RowsOfMarksAndDashesAboveEachOtherAreNoFiguresThatClimb) {
    draw(200, 150, two), draw(214, 150, four);
    for (const int y : {20, 80, 140}) draw(20, y, {"#######"});  // samples of a legend
    EXPECT_TRUE(told(true).empty());
    for (const int y : {20, 80, 140}) disc(80, y, 5, 7);  // circles are as high as wide
    EXPECT_TRUE(told(true).empty());
}

TEST_F(UnreadPrint, SpecksOfNoiseBesideItLeaveItFree) {
    draw(20, 150, two), draw(34, 150, four);
    draw(100, 150, two);
    draw(104, 165, {"#"});  // right below it
    EXPECT_TRUE(has(told(true), 101, 151));
    for (int x = 100; x < 110; ++x) picture.row(165)[x] = 0;
    EXPECT_FALSE(has(told(true), 101, 151)) << "more than a speck";
}

TEST_F(UnreadPrint, WhatIsNotAsLargeAsPrintOrTouchesIsNone) {
    draw(20, 150, two), draw(34, 150, four);
    std::vector<std::string_view> large;
    for (const std::string_view row : two) large.insert(large.end(), 3, row);
    draw(100, 50, large);
    draw(200, 150, four);
    for (int y = 20; y < 190; ++y) picture.row(y)[211] = 0;  // an axis right beside it
    EXPECT_TRUE(told(true).empty());
}

// A word that an arrow runs by, in line with print.
TEST_F(UnreadPrint, WhatIsReadByHalfMayTouchALine) {
    draw(20, 150, two), draw(34, 150, four);
    draw(200, 150, two), draw(214, 150, four);
    for (int y = 20; y < 190; ++y) picture.row(y)[225] = 0;
    EXPECT_TRUE(has(told(true, {"24", "2A"}), 201, 151));
    EXPECT_FALSE(has(told(true, {"24", "AB"}), 201, 151));
    EXPECT_FALSE(has(told(true, {"24", "242"}), 201, 151));
    EXPECT_FALSE(has(told(true, {"|4", "|4"}), 201, 151)) << "lines are read so";
}

// "Ber" of "Berlin", through which a border runs.
TEST_F(UnreadPrint, AWordThatIsBegunMayTouchALineAnywhere) {
    draw(20, 20, two), draw(34, 20, four);
    draw(200, 150, two), draw(214, 150, four), draw(228, 150, two);
    for (int y = 120; y < 190; ++y) picture.row(y)[239] = 0;
    EXPECT_TRUE(has(told(true, {"Ber °", "Ber ©"}), 201, 151));
    EXPECT_FALSE(has(told(true, {"Ber", "Bar"}), 201, 151));
    EXPECT_FALSE(has(told(true, {"OIO", "OIO"}), 201, 151)) << "marks are read so";
}

// "RAM" in print whose serifs touch; a zigzag is read as the same letter again and again.
TEST_F(UnreadPrint, LettersThatAllTouchAreTold) {
    draw(20, 150, two), draw(34, 150, four);
    draw(100, 60,
         {"#####  ####  #   #", "#   #  #  #  ## ##", "#   #  #  #  # # #", "##################", "#  #   #  #  #   #",
          "#   #  #  #  #   #", "#   #  #  #  #   #"});
    EXPECT_TRUE(has(told(true, {"RAM", "RA"}), 110, 66));
    EXPECT_FALSE(has(told(true, {"RAM", "WI"}), 110, 66));
    EXPECT_FALSE(has(told(true, {"WWW", "WW"}), 110, 66));
}

TEST_F(UnreadPrint, ABarAsHighAsPrintMayBeAnI) {
    draw(20, 20, two), draw(34, 20, four);
    draw(200, 150, {"#", "#", "#", "#", "#", "#", "#"});
    EXPECT_TRUE(has(told(true, {}, "I"), 201, 151));
    EXPECT_TRUE(has(told(true, {}, "°"), 201, 151));
    EXPECT_FALSE(has(told(true, {}, "|"), 201, 151));
    draw(200, 150, {"#", "#", "#", "#", "#", "#", "#", "#", "#"});
    EXPECT_FALSE(has(told(true, {}, "I"), 201, 151)) << "higher than print";
}

}  // namespace
}  // namespace tactics::unread_test
