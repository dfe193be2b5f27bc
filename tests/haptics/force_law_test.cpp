// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/force_law.h"

#include <gtest/gtest.h>

#include <limits>

namespace tactics::force_law_test {
namespace {

TEST(ForceLaw, IsNothingWithoutContact) {
    for (const DampingSign sign : {DampingSign::corrected, DampingSign::as_printed})
        for (const double before : {0.0, 10.0, 11.0, 40.0}) {
            EXPECT_EQ(force({2, 5, sign}, 10, 10, before, 0.001), 0);
            EXPECT_EQ(force({2, 5, sign}, 10, 10.01, before, 0.001), 0);
        }
}

TEST(ForceLaw, IsThatOfASpringAtRest) {
    EXPECT_DOUBLE_EQ(force({2, 5}, 10, 9, 9, 0.001), 2);
    EXPECT_DOUBLE_EQ(coupling_force({2, 5}, 10, 11, 11, 0.001), -2);
}

TEST(ForceLaw, ResistsMotionAsCorrectedAndHelpsItAsPrinted) {
    // Into the object by 0.01 mm in a tick: 10 mm/s, against which 5 N s/m are 0.05 N.
    EXPECT_NEAR(force({2, 5}, 10, 9, 9.01, 0.001), 2.05, 1e-12);
    EXPECT_NEAR(force({2, 5, DampingSign::as_printed}, 10, 9, 9.01, 0.001), 1.95, 1e-12);
    // The work of the damping term on a small swing within the object.
    double corrected = 0, printed = 0;
    double before = 9;
    for (const double now : {9.1, 9.0, 8.9, 9.0}) {
        corrected += (force({2, 5}, 10, now, before, 0.001) - force({2, 0}, 10, now, before, 0.001)) * (now - before);
        printed += (force({2, 5, DampingSign::as_printed}, 10, now, before, 0.001) - force({2, 0}, 10, now, before, 0.001)) *
                   (now - before);
        before = now;
    }
    EXPECT_LT(corrected, 0);
    EXPECT_GT(printed, 0);
}

TEST(ForceLaw, NeverPullsAndKnowsNoNumberThatIsNone) {
    EXPECT_EQ(force({1, 8}, 10, 9.99, 5, 0.001), 0);  // out of it at 5 m/s
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_EQ(force({1, 1}, bad, 9, 9, 0.001), 0) << bad;
        EXPECT_EQ(force({1, 1}, 10, 9, bad, 0.001), 0) << bad;
        EXPECT_EQ(coupling_force({1, 1}, bad, 9, 9, 0.001), 0) << bad;
    }
    EXPECT_EQ(force({1, 1}, 10, nan, 9, 0.001), 0);
    EXPECT_EQ(force({1, 1}, 10, 9, 9, 0), 0);
    EXPECT_EQ(force({1, 1}, 10, 9, 9, nan), 0);
}

}  // namespace
}  // namespace tactics::force_law_test
