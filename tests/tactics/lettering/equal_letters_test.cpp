// SPDX-License-Identifier: Apache-2.0
// Word spaces in monospaced print.
#include "tactics/lettering/equal_letters.h"

#include <gtest/gtest.h>

#include <numeric>

namespace tactics::equal_letters_test {
namespace {

// Two words of x-high letters, so far apart from middle to middle within them and between them.
bool is_space(int letter, int space, int narrow = 0) {
    std::vector<PixelBox> boxes;
    for (const int middle : {0, letter, 2 * letter, 2 * letter + space, 3 * letter + space, 4 * letter + space}) {
        const int half = middle == 2 * letter ? 4 - narrow : 4;
        boxes.push_back({100 + middle - half, 50, 100 + middle + half, 58});
    }
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    return is_space_of_equal_letters(boxes, order, 2, 3);
}

TEST(EqualLetters, HaveSpacesAsWideAsALetter) {
    EXPECT_TRUE(is_space(10, 20));
    EXPECT_TRUE(is_space(10, 20, 3)) << "an i before it";
    EXPECT_TRUE(is_space(11, 21));
    EXPECT_FALSE(is_space(10, 30)) << "columns of a table";
    EXPECT_FALSE(is_space(10, 25));
    EXPECT_FALSE(is_space(10, 16)) << "proportional print";
}

TEST(EqualLetters, AreThereOnBothSidesOfASpace) {
    const std::vector<PixelBox> two{{0, 0, 8, 8}, {20, 0, 28, 8}};
    EXPECT_FALSE(is_space_of_equal_letters(two, {0, 1}, 0, 1));
    const std::vector<PixelBox> three{{-10, 0, -2, 8}, {0, 0, 8, 8}, {20, 0, 28, 8}};
    EXPECT_FALSE(is_space_of_equal_letters(three, {0, 1, 2}, 1, 2));
}

}  // namespace
}  // namespace tactics::equal_letters_test
