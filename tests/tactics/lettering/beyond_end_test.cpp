// SPDX-License-Identifier: Apache-2.0
// What touches a line of print may be one of its letters; a line that only leads to it is none.
#include "tactics/lettering/beyond_end.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace tactics::beyond_end_test {
namespace {

// Three letters as an L is, 14 pixels high, that end at x = 64, on a foot at y = 34.
Image three_letters() {
    Image image = make_image(120, 60, 1, 0, 255);
    for (const int left : {30, 42, 54})
        for (int y = 20; y < 34; ++y)
            for (int x = left; x < left + (y < 32 ? 2 : 10); ++x) image.row(y)[x] = 0;
    return image;
}

bool is_cut_off(const Image& image) {
    for (const LetteringLine& line : find_lettering(image))
        if (line.letters.size() == 3) return is_cut(image, line, 0.3);
    ADD_FAILURE() << "the letters were not found";
    return false;
}

// From there down to the right, two pixels down for each to the side.
void tick(Image& image, int left, int top, int rows) {
    for (int i = 0; i < rows; ++i) image.row(top + i)[left + i / 2] = 0;
}

TEST(BeyondEnd, NothingIsThere) { EXPECT_FALSE(is_cut_off(three_letters())); }

TEST(BeyondEnd, WhatEndsAtTheMiddleMayHaveALetter) {
    for (const int row : {27, 33}) {  // nor does it pass the corner where it is level with the foot
        Image image = three_letters();
        std::fill(image.row(row) + 67, image.row(row) + 115, std::uint8_t{0});
        EXPECT_TRUE(is_cut_off(image)) << row;
    }
}

TEST(BeyondEnd, ALineThatPassesIsNoneAtAnySlope) {
    for (const bool hides : {false, true}) {  // a letter behind it
        Image image = three_letters();
        for (int y = 2; y < 58; ++y)
            for (int x = 0; x < 2; ++x) image.row(y)[63 + (y - 2) / 5 + x] = 0;
        for (int y = 24; hides && y < 27; ++y) std::fill(image.row(y) + 69, image.row(y) + 73, std::uint8_t{0});
        EXPECT_EQ(is_cut_off(image), hides);
    }
}

TEST(BeyondEnd, ALineThatLeadsToACornerIsNone) {
    Image image = three_letters();
    tick(image, 67, 32, 16);
    EXPECT_FALSE(is_cut_off(image));
    Image above = three_letters();
    tick(above, 61, 8, 14);
    EXPECT_FALSE(is_cut_off(above));
}

// A line from above to below 24 pixels behind the letters, and what sticks out of it: to the left edge there, in those rows.
Image with_line_behind(int out, int top, int bottom) {
    Image image = three_letters();
    for (int y = 2; y < 58; ++y) std::fill(image.row(y) + 88, image.row(y) + 90, std::uint8_t{0});
    for (int y = top; y < bottom; ++y) std::fill(image.row(y) + out, image.row(y) + 88, std::uint8_t{0});
    return image;
}

TEST(BeyondEnd, ALetterThatTouchesALineSticksOutOfIt) {
    EXPECT_TRUE(is_cut_off(with_line_behind(76, 20, 34)));
    EXPECT_FALSE(is_cut_off(with_line_behind(88, 20, 34))) << "a line alone";
    EXPECT_FALSE(is_cut_off(with_line_behind(76, 23, 31))) << "what is not as high as a letter";
    EXPECT_FALSE(is_cut_off(with_line_behind(82, 20, 34))) << "farther off than words are";
}

TEST(BeyondEnd, WhatStandsBeforeALineOrPointsAtItIsNone) {
    Image apart = with_line_behind(76, 20, 34);
    for (int y = 0; y < 60; ++y) std::fill(apart.row(y) + 84, apart.row(y) + 87, std::uint8_t{255});
    EXPECT_FALSE(is_cut_off(apart));
    Image arrow = with_line_behind(82, 20, 34);
    for (int y = 26; y < 28; ++y) std::fill(arrow.row(y) + 74, arrow.row(y) + 82, std::uint8_t{0});  // its shaft
    EXPECT_FALSE(is_cut_off(arrow));
    Image bent = with_line_behind(76, 20, 34);
    for (int y = 36; y < 58; ++y) {
        std::fill(bent.row(y) + 88, bent.row(y) + 90, std::uint8_t{255});
        bent.row(y)[90 + (y - 36)] = 0;
    }
    EXPECT_FALSE(is_cut_off(bent)) << "the corner of a shape";
}

// As the bar of an e is that lies across two rows of pixels; the low line of "X_1" stands below.
TEST(BeyondEnd, PaleInkWithinALetterIsNotStrange) {
    for (const int top : {25, 38}) {
        Image image = three_letters();
        for (int y = top; y < top + 2; ++y) std::fill(image.row(y) + 46, image.row(y) + 51, std::uint8_t{140});
        const std::vector<LetteringLine> lines = find_lettering(image);
        ASSERT_EQ(lines.size(), 1u);
        ASSERT_EQ(lines[0].letters.size(), 3u);
        EXPECT_EQ(has_strange_ink(image, lines[0]), top > 34) << top;
    }
}

}  // namespace
}  // namespace tactics::beyond_end_test
