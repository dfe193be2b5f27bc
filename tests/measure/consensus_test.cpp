// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/consensus.h"

#include <gtest/gtest.h>

namespace tactics::consensus_test {
namespace {

constexpr int kWidth = 400, kHeight = 300;  // a diagonal of 500, near is 3.75 pixels

PixelSet column(int x) {
    PixelSet set{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y) set.pixels.push_back(static_cast<std::uint32_t>(y * kWidth + x));
    return set;
}

PixelSet both(const PixelSet& a, const PixelSet& b) {
    PixelSet set = a;
    set.pixels.insert(set.pixels.end(), b.pixels.begin(), b.pixels.end());
    std::sort(set.pixels.begin(), set.pixels.end());
    return set;
}

// The border of a rectangle; its last column and row are line, too.
PixelSet frame(int left, int top, int right, int bottom) {
    PixelSet set{kWidth, kHeight, {}};
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x)
            if (x == left || x == right || y == top || y == bottom)
                set.pixels.push_back(static_cast<std::uint32_t>(y * kWidth + x));
    return set;
}

TEST(Consensus, CountsWhoDrewWhatIsDrawn) {
    // Three drew column 100 or near it, one of them another line, too.
    const std::vector<PixelSet> people{column(100), column(103), both(column(99), column(300))};
    const Consensus consensus(people);
    const PageShares shares = consensus.shares_of(both(column(101), column(200)));
    EXPECT_DOUBLE_EQ(shares.p3, 0.5);
    EXPECT_DOUBLE_EQ(shares.p1, 0.5);
    EXPECT_DOUBLE_EQ(shares.r3.value(), 1);
    EXPECT_DOUBLE_EQ(shares.diagonals, 600.0 / 500);
    EXPECT_FALSE(shares.main_object.has_value());
    // Near the line of one alone, and of two. All three are near column 100 only: 99 and 103 are 4 pixels apart.
    const PageShares other = consensus.shares_of(both(column(302), column(97)));
    EXPECT_DOUBLE_EQ(other.p1, 1);
    EXPECT_DOUBLE_EQ(other.p3, 0);
    EXPECT_DOUBLE_EQ(other.r3.value(), 1);
    EXPECT_DOUBLE_EQ(consensus.shares_of(both(column(302), column(96))).r3.value(), 0);
    const PageShares nothing = consensus.shares_of(PixelSet{kWidth, kHeight, {}});
    EXPECT_EQ(nothing.p3 + nothing.p1 + nothing.r3.value() + nothing.diagonals, 0);
    // Two do not agree as three.
    EXPECT_FALSE(Consensus(std::vector<PixelSet>{column(1), column(1)}).shares_of(column(1)).r3.has_value());
}

TEST(Consensus, TheMainObjectIsTheLargestThatIsWhole) {
    // A large part at the frame does not count, nor one of less than 1 %, nor the rest around.
    const PixelSet drawn = both(both(frame(200, 100, 260, 160), frame(300, 200, 380, 280)), frame(100, 100, 110, 110));
    const auto outline = main_outline(drawn);
    EXPECT_EQ(outline, frame(300, 200, 380, 280).pixels);
    EXPECT_TRUE(main_outline(column(50)).empty());
    EXPECT_TRUE(main_outline(frame(10, 10, 390, 290)).empty());  // over 60 %
    // Drawn is its left side, of 320 pixels 81, and so much of the two next to it as is near: 3 of each.
    const std::vector<PixelSet> people{drawn, column(50)};
    PixelSet side{kWidth, kHeight, {}};
    for (std::uint32_t y = 200; y <= 280; ++y) side.pixels.push_back(y * kWidth + 300);
    EXPECT_DOUBLE_EQ(Consensus(people).shares_of(side).main_object.value(), (81.0 + 6) / 320);
}

TEST(Consensus, APageIsPoorIfAPersonsIsBetterAndMuchIsWrongOrMissing) {
    const auto page = [](double p3, double r3, double main) {
        PageShares shares;
        shares.p3 = p3;
        shares.r3 = r3;
        shares.main_object = main;
        return shares;
    };
    const PageShares person = page(0.9, 0.8, 0.8);
    EXPECT_FALSE(is_poor(page(0.7, 0.5, 0.2), person));
    EXPECT_TRUE(is_poor(page(0.6, 0.9, 0.9), person)) << "a third of it is not what people agree on";
    EXPECT_FALSE(is_poor(page(0.6, 0.9, 0.9), page(0.65, 0.8, 0.8))) << "nor are the people at one";
    EXPECT_TRUE(is_poor(page(1, 0.4, 0.5), person)) << "the main object is lost";
    EXPECT_FALSE(is_poor(page(1, 0.4, 0.7), person)) << "only what stands around it";
    EXPECT_FALSE(is_poor(page(1, 0.4, 0.5), page(0.9, 0.45, 0.8)));
    EXPECT_FALSE(is_poor(person, person));
}

TEST(Consensus, TheSimplestPersonHasTheFewestRegions) {
    const std::vector<PixelSet> people{both(column(100), column(200)), column(100), column(200)};
    EXPECT_EQ(simplest_of(people), 1u);
    const auto others = others_than(people, 1);
    ASSERT_EQ(others.size(), 2u);
    EXPECT_EQ(others[0].pixels, people[0].pixels);
    EXPECT_EQ(others[1].pixels, people[2].pixels);
}

}  // namespace
}  // namespace tactics::consensus_test
