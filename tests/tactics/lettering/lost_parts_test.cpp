// SPDX-License-Identifier: Apache-2.0
// A label of which a part is hidden by what is drawn is told as a whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "tactics/lettering/read_line.h"

namespace tactics::lost_parts_test {
namespace {

// A label of three letters as an L is, 14 pixels high, from x = 30, which was read for sure, and two stems behind it.
class LostParts : public ::testing::Test {
protected:
    LostParts() {
        for (const int left : {30, 42, 54}) stem(left, 20, 34), fill(left, 32, left + 10, 34);
    }
    void fill(int left, int top, int right, int bottom) {
        for (int y = top; y < bottom; ++y) std::fill(picture.row(y) + left, picture.row(y) + right, std::uint8_t{0});
    }
    void stem(int left, int top, int bottom) { fill(left, top, left + 2, bottom); }
    // Of the line at the left, given what the other is read as, and whether that is told.
    bool is_sure(const std::string& text, const std::string& other, bool told) {
        std::vector<ReadLine> lines;
        for (LetteringLine& line : find_lettering(picture)) {
            if (!is_words(line)) continue;
            ReadLine one{std::move(line), {}};
            one.words.sure = one.line.box.left < 40;
            one.words.text = one.words.sure ? text : other;
            lines.push_back(std::move(one));
        }
        EXPECT_EQ(lines.size(), 2u);
        doubt_parts(picture, lines, std::vector<bool>(lines.size(), told));
        const auto label = std::find_if(lines.begin(), lines.end(), [](const ReadLine& one) { return one.line.box.left < 40; });
        EXPECT_NE(label->words.sure, label->tell);
        return label->words.sure;
    }
    Image picture = make_image(160, 60, 1, 0, 255);
};

TEST_F(LostParts, WhatGoesOnBehindALineIsOfTheLabel) {
    stem(84, 20, 34), stem(89, 20, 34);
    EXPECT_TRUE(is_sure("Mount", "", false)) << "nothing is between";
    fill(72, 4, 74, 56);  // what a letter touches
    EXPECT_FALSE(is_sure("Mount", "", false));
    EXPECT_TRUE(is_sure("12", "", false)) << "a scale";
}

TEST_F(LostParts, WhatIsNotAsHighIsNone) {
    stem(84, 22, 31), stem(89, 22, 31);
    fill(72, 4, 74, 56);
    EXPECT_TRUE(is_sure("Mount", "", false));
}

TEST_F(LostParts, APartThatIsToldMayStandFartherOffBehindALine) {
    stem(84, 20, 34), stem(89, 20, 34);  // 20 pixels behind it
    EXPECT_TRUE(is_sure("vir", "ll", true));
    fill(72, 4, 74, 56);
    EXPECT_FALSE(is_sure("vir", "ll", true));
}

// Two words of an L each, with a line between them that leans by so many pixels.
bool is_sure_of_two(const std::string& text, int leans) {
    Image picture = make_image(100, 60, 1, 0, 255);
    const auto fill = [&](int left, int top, int right, int bottom) {
        for (int y = top; y < bottom; ++y) std::fill(picture.row(y) + left, picture.row(y) + right, std::uint8_t{0});
    };
    for (const int left : {30, 50}) fill(left, 20, left + 2, 34), fill(left, 32, left + 8, 34);
    std::vector<ReadLine> lines{{find_lettering(picture).at(0), {}}};
    EXPECT_EQ(lines[0].line.letters.size(), 2u);
    lines[0].words.sure = true;
    lines[0].words.text = text;
    for (int y = 0; y < 60; ++y) fill(43 + leans * (y - 30) / 30, y, 45 + leans * (y - 30) / 30, y + 1);
    doubt_parted(picture, lines);
    return lines[0].words.sure;
}

// Of "n = n - 1" the dash belongs to neither part.
TEST(PartedLabel, AFormulaGoesOnBehindADash) {
    for (const auto& [text, dash, sure] :
         {std::tuple{"L = L", 6, false}, {"L L", 6, true}, {"L = L", 18, true}, {"L = L", 0, true}}) {
        Image picture = make_image(160, 60, 1, 0, 255);
        const auto fill = [&](int left, int top, int right, int bottom) {
            for (int y = top; y < bottom; ++y) std::fill(picture.row(y) + left, picture.row(y) + right, std::uint8_t{0});
        };
        for (const int left : {20, 40, 76, 96}) fill(left, 20, left + 2, 34), fill(left, 32, left + 8, 34);
        std::vector<ReadLine> lines;
        for (const LetteringLine& line : find_lettering(picture)) lines.push_back({line, {}});
        ASSERT_EQ(lines.size(), 2u);
        for (ReadLine& line : lines) {
            line.words.sure = true;
            line.words.text = line.line.box.left < 60 ? text : "1";
        }
        fill(62 - dash / 2, 26, 62 + dash / 2, 28);
        doubt_parted(picture, lines);
        for (const ReadLine& line : lines) EXPECT_EQ(line.words.sure, sure) << text << ' ' << dash;
    }
}

TEST(PartedLabel, NothingIsHiddenByALineThatLeans) {
    EXPECT_FALSE(is_sure_of_two("L L", 0)) << "or Lil";
    EXPECT_TRUE(is_sure_of_two("L L", 11));
    EXPECT_FALSE(is_sure_of_two("1 1", 11)) << "or 1.1";
}

}  // namespace
}  // namespace tactics::lost_parts_test
