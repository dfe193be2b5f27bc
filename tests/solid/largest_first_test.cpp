// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/largest_first.h"

#include <gtest/gtest.h>

namespace tactics::largest_first_test {
namespace {

using Order = std::vector<std::size_t>;

TEST(LargestFirst, WhatIsNearlyAlikeKeepsItsOrder) {
    EXPECT_EQ(largest_first({}, 0.01), Order());
    EXPECT_EQ(largest_first({1, 3, 2}, 0.01), (Order{1, 2, 0}));
    EXPECT_EQ(largest_first({1, 1.001, 0.999, 5}, 0.01), (Order{3, 0, 1, 2}));
    // Each is like the next, the first not like the last: still one size, whatever order they come in.
    EXPECT_EQ(largest_first({1, 1.007, 1.014}, 0.01), (Order{0, 1, 2}));
    EXPECT_EQ(largest_first({1.014, 1, 1.007}, 0.01), (Order{0, 1, 2}));
    EXPECT_EQ(largest_first({0, 0}, 0.01), (Order{0, 1}));
}

TEST(MakeAlike, WhatIsNearlyAlikeBecomesOneNumber) {
    std::vector<double> numbers = {2, 5, 2.001, 5.02, 1.999, -2, 0};
    make_alike(numbers, 1e-3);
    EXPECT_EQ(numbers[0], numbers[2]);
    EXPECT_EQ(numbers[0], numbers[4]);
    EXPECT_NEAR(numbers[0], 2, 2e-3);
    EXPECT_EQ(numbers[1], 5);
    EXPECT_EQ(numbers[3], 5.02);
    EXPECT_EQ(numbers[5], -2);
    EXPECT_EQ(numbers[6], 0);
    std::vector<double> angles = {1e-9, 0, -1e-9, 0.1};
    make_alike(angles, 0, 1e-6);
    EXPECT_EQ(angles[0], angles[1]);
    EXPECT_EQ(angles[1], angles[2]);
    EXPECT_EQ(angles[3], 0.1);
    // A row in which each is like the next does not become one number from end to end.
    std::vector<double> row;
    for (int i = 0; i < 1000; ++i) row.push_back(1 + 0.9e-3 * i);
    make_alike(row, 1e-3);
    for (int i = 0; i < 1000; ++i) EXPECT_NEAR(row[static_cast<std::size_t>(i)], 1 + 0.9e-3 * i, 0.02);
}

}  // namespace
}  // namespace tactics::largest_first_test
