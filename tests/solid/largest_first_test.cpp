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

}  // namespace
}  // namespace tactics::largest_first_test
