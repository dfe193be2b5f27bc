// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/entropy.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "tests/information/sources.h"

namespace tactics::tests::entropy_test {
namespace {

// Equation 2 of the paper.
TEST(Entropy, OfThePapersVoxelsIsAThousandBits) {
    LevelGrid voxels{5, 5, 5, 256, std::vector<std::uint16_t>(125)};
    EXPECT_EQ(raw_bits(voxels), 1000.0);
    const std::vector<std::uint64_t> evenly(256, 7);
    EXPECT_EQ(125 * entropy_of(evenly).plug_in, 1000.0);
}

TEST(Entropy, OfKnownSharesIsKnown) {
    const std::uint64_t coin[] = {500, 500}, bent[] = {250, 750, 0, 0}, one[] = {0, 9}, none[] = {0, 0};
    EXPECT_DOUBLE_EQ(entropy_of(coin).plug_in, 1);
    EXPECT_NEAR(entropy_of(bent).plug_in, 0.811278, 1e-6);
    EXPECT_EQ(entropy_of(bent).distinct, 2u);
    EXPECT_EQ(entropy_of(one).corrected, 0);
    EXPECT_EQ(entropy_of(none).corrected, 0);
}

// From few samples the shares alone tell too little; put right, the mean of many trials is nearer by far.
TEST(Entropy, ItsBiasIsPutRight) {
    double plug_in = 0, corrected = 0;
    constexpr int kTrials = 200;
    for (int i = 0; i < kTrials; ++i) {
        const Entropy one = entropy_of(noise(16, 16, 32, 100 + static_cast<std::uint64_t>(i)));
        plug_in += one.plug_in / kTrials;
        corrected += one.corrected / kTrials;
    }
    EXPECT_LT(plug_in, 4.94);
    EXPECT_GT(corrected, 4.985);
    EXPECT_LE(corrected, 5);
}

double naive(const std::map<std::pair<int, int>, double>& counts) {
    double all = 0, bits = 0;
    for (const auto& [value, count] : counts) all += count;
    for (const auto& [value, count] : counts) bits -= count / all * std::log2(count / all);
    return bits;
}

TEST(Entropy, OfTwoGridsTogetherIsThatOfTheirPairs) {
    for (const int levels : {4, 256, 5000}) {  // in a table, and sorted
        const LevelGrid a = terrain(60, 50, levels, 1), b = noise(60, 50, levels, 2);
        std::map<std::pair<int, int>, double> counts;
        for (std::size_t i = 0; i < a.count(); ++i) ++counts[{a.values[i], b.values[i]}];
        EXPECT_NEAR(joint_entropy(a, b).joint.plug_in, naive(counts), 1e-9) << levels;
        EXPECT_EQ(joint_entropy(a, b).joint.distinct, counts.size());
    }
}

TEST(Entropy, WhatIsTheSameTellsAllAndWhatIsByItselfNothing) {
    const LevelGrid a = noise(400, 300, 8, 1), b = noise(400, 300, 8, 2);
    EXPECT_NEAR(joint_entropy(a, a).mutual(), entropy_of(a).corrected, 1e-9);
    EXPECT_NEAR(joint_entropy(a, a).conditional(), 0, 1e-9);
    EXPECT_NEAR(joint_entropy(a, b).mutual(), 0, 1e-3);
    EXPECT_NEAR(joint_entropy(a, b).conditional(), 3, 1e-2);
    // It is symmetric, and a function of one tells no more than its own entropy.
    const LevelGrid coarse = with_levels(a, 2);
    EXPECT_DOUBLE_EQ(joint_entropy(a, coarse).mutual(), joint_entropy(coarse, a).mutual());
    EXPECT_NEAR(joint_entropy(a, coarse).mutual(), entropy_of(coarse).corrected, 1e-4);
    EXPECT_THROW(joint_entropy(a, noise(300, 400, 8, 3)), std::logic_error);
}

}  // namespace
}  // namespace tactics::tests::entropy_test
