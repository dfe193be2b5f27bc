// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/truth.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tactics::truth_test {
namespace {

using Paths = std::vector<std::string>;

TEST(Truth, IsPairedByName) {
    const Pairing pairing = pair_up({"images/b.jpg", "images/a.v2.png", "images/c_gt1.jpg"},
                                    {"gt/b_gt10.png", "gt/b_gt2.png", "gt/a.v2_gt1.png", "gt/c_gt1_gt3.png"});
    EXPECT_TRUE(pairing.problems.empty());
    ASSERT_EQ(pairing.subjects.size(), 3u);
    EXPECT_EQ(pairing.subjects[0].name, "a.v2");
    EXPECT_EQ(pairing.subjects[0].truths, Paths{"gt/a.v2_gt1.png"});
    EXPECT_EQ(pairing.subjects[1].picture, "images/b.jpg");
    EXPECT_EQ(pairing.subjects[1].truths, (Paths{"gt/b_gt2.png", "gt/b_gt10.png"}));
    EXPECT_EQ(pairing.subjects[2].truths, Paths{"gt/c_gt1_gt3.png"});
}

TEST(Truth, NothingIsLeftOutSilently) {
    const Pairing pairing = pair_up({"a.jpg", "a.png", "b.jpg"}, {"a_gt1.png", "c_gt1.png", "b.png", "b_gt.png", "b_gt1x.png"});
    ASSERT_EQ(pairing.subjects.size(), 2u);
    EXPECT_EQ(pairing.subjects[1].truths, Paths{});
    EXPECT_EQ(pairing.problems.size(), 5u);  // the second a; c; three names that are none
    for (const std::string named : {"a.png: ", "c_gt1.png: ", "b.png: ", "b_gt.png: ", "b_gt1x.png: "})
        EXPECT_TRUE(std::any_of(pairing.problems.begin(), pairing.problems.end(), [&](const Phrase& problem) {
            return problem.english().starts_with(named);
        })) << named;
}

}  // namespace
}  // namespace tactics::truth_test
