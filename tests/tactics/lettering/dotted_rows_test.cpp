// SPDX-License-Identifier: Apache-2.0
// Dots and dashes of a line that is drawn go; those of print stay.
#include "tactics/lettering/dotted_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tactics::dotted_rows_test {
namespace {

class DottedRow : public ::testing::Test {
protected:
    void fill(int left, int top, int wide, int high) {
        for (int y = top; y < top + high; ++y) std::fill(grey.row(y) + left, grey.row(y) + left + wide, std::uint8_t{0});
    }
    bool is_ink(int x, int y) const { return without_dotted_rows(grey).row(y)[x] < 128; }
    Image grey = make_image(200, 160, 1, 0, 255);
};

TEST_F(DottedRow, GoesAndALetterBesideItStays) {
    for (int i = 0; i < 9; ++i) fill(40 + 2 * i, 10 + 16 * i, 2, 4);
    fill(52, 70, 3, 16);
    EXPECT_FALSE(is_ink(40, 11));
    EXPECT_FALSE(is_ink(48, 75));
    EXPECT_TRUE(is_ink(53, 75));
}

TEST_F(DottedRow, MayBendAndHaveDashes) {
    for (int i = 0; i < 8; ++i) {
        const double turn = 0.1 + 0.16 * i;
        for (int k = 0; k < 9; ++k) {
            const double at = turn + 0.01 * k;
            fill(static_cast<int>(150 * std::cos(at)), static_cast<int>(10 + 140 * std::sin(at)), 2, 2);
        }
    }
    const Image without = without_dotted_rows(grey);
    EXPECT_TRUE(std::all_of(without.pixels.begin(), without.pixels.end(), [](std::uint8_t value) { return value >= 128; }));
}

TEST_F(DottedRow, IsNoColumnOfPointsOfNumbers) {
    for (int i = 0; i < 6; ++i) fill(40, 10 + 24 * i, 2, 2);
    EXPECT_TRUE(is_ink(40, 10));
}

TEST_F(DottedRow, HasMoreDotsThanAnEllipsis) {
    for (int i = 0; i < 4; ++i) fill(40 + 8 * i, 100, 3, 3);
    EXPECT_TRUE(is_ink(41, 101));
}

// The life line of a sequence diagram below a name: as far apart, as long, and as thick.
TEST_F(DottedRow, DoesNotGoOnInAnIBetweenLetters) {
    for (int i = 0; i < 6; ++i) fill(60, 60 + 16 * i, 2, 9);
    fill(60, 44, 2, 9);
    EXPECT_FALSE(is_ink(61, 48));
    fill(54, 40, 3, 13);
    fill(65, 44, 8, 9);
    EXPECT_TRUE(is_ink(61, 48));
    EXPECT_FALSE(is_ink(61, 64));
}

}  // namespace
}  // namespace tactics::dotted_rows_test
