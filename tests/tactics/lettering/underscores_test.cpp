// SPDX-License-Identifier: Apache-2.0
// Underscores belong to the names that have them, dashes below a line do not.
#include "tactics/lettering/underscores.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "tactics/lettering/lines.h"

namespace tactics::underscores_test {
namespace {

constexpr int kFoot = 32, kHigh = 12;

void fill(Image& image, const PixelBox& box) {
    for (int y = box.top; y < box.bottom; ++y) std::fill(image.row(y) + box.left, image.row(y) + box.right, 0);
}

// Letters of 8 by 12 pixels as L, 3 apart; an underscore is as wide and has two pixels below the line.
Image written(const std::string& text, int more_rows = 0) {
    Image image = make_image(260, 60 + more_rows, 1, 0, 255);
    int left = 20;
    for (const char c : text) {
        if (c == 'L') fill(image, {left, kFoot - kHigh, left + 3, kFoot}), fill(image, {left + 3, kFoot - 3, left + 8, kFoot});
        if (c == '_') fill(image, {left - 1, kFoot + 2, left + 10, kFoot + 4});
        left += 11;
    }
    return image;
}

TEST(Underscores, JoinWhatIsOnBothSidesAndBelongToItsEnds) {
    for (const char* text : {"LL_LLL", "LL__LL", "_LLL", "LLL_", "__LL__", "L_L_L_L"}) {
        const auto lines = find_lettering(written(text));
        ASSERT_EQ(lines.size(), 1u) << text;
        const std::string_view all(text);
        EXPECT_EQ(lines[0].letters.size(), static_cast<std::size_t>(std::count(all.begin(), all.end(), 'L'))) << text;
        EXPECT_EQ(lines[0].box.bottom, kFoot + 4) << text;
        EXPECT_EQ(lines[0].box.left, all.front() == '_' ? 19 : 20) << text;
    }
}

// The two lines are as close as print is set.
TEST(Underscores, AreNotTakenByTheLineBelow) {
    Image image = written("LL_LLL", 40);
    const Image below = written("LLLLLL");
    for (int y = kFoot - kHigh; y < kFoot; ++y) std::copy_n(below.row(y), below.width, image.row(y + 19));
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 2u);
    const bool first_is_upper = lines[0].box.top < lines[1].box.top;
    EXPECT_EQ(lines[first_is_upper ? 0 : 1].marks.size(), 1u);
    EXPECT_TRUE(lines[first_is_upper ? 1 : 0].marks.empty());
}

TEST(Underscores, ADashedLineBelowHasNone) {
    Image image = written("LLLL");
    for (int left = 2; left < 250; left += 20) fill(image, {left, kFoot + 2, left + 11, kFoot + 4});
    for (const LetteringLine& line : find_lettering(image)) EXPECT_TRUE(line.marks.empty());
    // A line that is drawn under a word is none either.
    image = written("LLLL");
    fill(image, {18, kFoot + 2, 64, kFoot + 4});
    for (const LetteringLine& line : find_lettering(image)) EXPECT_TRUE(line.marks.empty());
}

TEST(Underscores, FillAGapAtTheFoot) {
    const PixelBox a{0, 0, 8, 12}, b{22, 0, 30, 12};
    EXPECT_TRUE(is_underscore_between({9, 14, 21, 15}, a, b));
    EXPECT_FALSE(is_underscore_between({9, 5, 21, 7}, a, b)) << "a minus sign";
    EXPECT_FALSE(is_underscore_between({9, 22, 21, 23}, a, b)) << "far below";
    EXPECT_FALSE(is_underscore_between({4, 14, 26, 15}, a, b)) << "a line under both";
    EXPECT_FALSE(is_underscore_between({9, 14, 12, 15}, a, b)) << "a point";
}

}  // namespace
}  // namespace tactics::underscores_test
