// SPDX-License-Identifier: Apache-2.0
// The name of an axis climbs beside its numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "tactics/lettering/lines.h"

namespace tactics::climbing_print_test {
namespace {

// An L, 12 pixels high, or such a one that climbs.
void write_l(Image& image, int left, int top, bool climbs) {
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 8; ++x)
            if (x < 3 || y > 8) (climbs ? image.row(top + 7 - x)[left + y] : image.row(top + y)[left + x]) = 0;
}

// Ten letters climb, with two figures on their left at so many of them.
std::size_t letters_that_climb(int numbers, int gap, int lower = 0) {
    Image image = make_image(120, 160, 1, 0, 255);
    for (int i = 0; i < 10; ++i) {
        write_l(image, 80, 20 + 11 * i, true);
        for (int k = 0; k < 2 && i % 2 == 0 && i / 2 < numbers; ++k)
            write_l(image, 80 - gap - 19 + 11 * k, 18 + 11 * i + lower, false);
    }
    std::size_t most = 0;
    for (const LetteringLine& line : find_lettering(image))
        if (line.upwards) most = std::max(most, line.letters.size());
    return most;
}

TEST(ClimbingPrint, StandsBesideNumbers) {
    EXPECT_EQ(letters_that_climb(0, 8), 10u);
    EXPECT_EQ(letters_that_climb(4, 8), 10u);
    EXPECT_EQ(letters_that_climb(3, 8, 5), 10u) << "two letters of the name are in the row of a number";
    EXPECT_EQ(letters_that_climb(4, 3), 0u) << "the letters of words in rows";
}

}  // namespace
}  // namespace tactics::climbing_print_test
