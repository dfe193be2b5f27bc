// SPDX-License-Identifier: Apache-2.0
// Numbers and names of an axis, right before its ticks.
#include "tactics/lettering/tick_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "tactics/lettering/lines.h"

namespace tactics::tick_ends_test {
namespace {

// Two rows of so many letters as an L is, 12 pixels high, each with a stroke of six pixels so far behind it.
std::size_t dashes(int letters, std::array<int, 2> gaps) {
    Image image = make_image(160, 100, 1, 0, 255);
    const auto fill = [&](int left, int top, int right, int bottom) {
        for (int y = top; y < bottom; ++y) std::fill(image.row(y) + left, image.row(y) + right, std::uint8_t{0});
    };
    for (const int row : {0, 1}) {
        const int top = 20 + 40 * row;
        for (int i = 0; i < letters; ++i) {
            fill(20 + 11 * i, top, 23 + 11 * i, top + 12);
            fill(20 + 11 * i, top + 9, 28 + 11 * i, top + 12);
        }
        const int left = 17 + 11 * letters + gaps[static_cast<std::size_t>(row)];
        fill(left, top + 5, left + 6, top + 7);
    }
    std::size_t count = 0;
    for (const LetteringLine& line : find_lettering(image)) count += line.marks.size();
    return count;
}

TEST(TickEnds, StandInAColumn) {
    EXPECT_EQ(dashes(2, {3, 3}), 0u);
    EXPECT_EQ(dashes(2, {3, 6}), 2u) << "two hyphens";
}

TEST(TickEnds, OfNamesStandApart) {
    EXPECT_EQ(dashes(7, {4, 4}), 0u);
    EXPECT_EQ(dashes(7, {1, 1}), 2u) << "lines of a text that are broken at hyphens";
}

}  // namespace
}  // namespace tactics::tick_ends_test
