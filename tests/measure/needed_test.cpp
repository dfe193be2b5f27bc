// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/needed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tactics::needed_test {
namespace {

double unit(std::mt19937& random) { return static_cast<double>(random() % 1001) / 1000; }

TEST(Needed, IsTheFirstThatIsNearlyTheBest) {
    std::mt19937 random(5);
    const std::vector<double> values{1, 2, 5, 10, 20, INFINITY};
    for (int i = 0; i < 1000; ++i) {
        NeededCurve curve;
        for (std::size_t k = 0; k < values.size(); ++k) curve.f.push_back(unit(random));
        curve.most = 1 + static_cast<double>(random() % 30);
        const auto index = smallest_enough(curve.f);
        ASSERT_TRUE(index);
        const auto best = static_cast<std::size_t>(std::max_element(curve.f.begin(), curve.f.end()) - curve.f.begin());
        EXPECT_LE(*index, best);
        EXPECT_GE(curve.f[*index], 0.99 * curve.f[best]);
        for (std::size_t k = 0; k < *index; ++k) EXPECT_LT(curve.f[k], 0.99 * curve.f[best]);
        EXPECT_LE(*needed_of(curve, values), std::min(values[best], curve.most));
        // More of something that does not help changes nothing.
        std::vector<double> longer = curve.f;
        longer.push_back(curve.f[best]);
        EXPECT_EQ(smallest_enough(longer), index);
    }
    EXPECT_FALSE(smallest_enough({}));
    EXPECT_FALSE(smallest_enough(std::vector<double>{0, 0}));
    EXPECT_EQ(smallest_enough(std::vector<double>{0.4949, 0.495, 0.5}), 1u);
}

TEST(Needed, QuartilesPartTheValues) {
    std::mt19937 random(6);
    for (int i = 0; i < 300; ++i) {
        std::vector<double> values;
        for (std::size_t k = 0, size = 1 + random() % 20; k < size; ++k) values.push_back(unit(random));
        const Quartiles quartiles = quartiles_of(values);
        const auto share = [&](double limit) {
            const auto below = std::count_if(values.begin(), values.end(), [&](double v) { return v <= limit + 1e-12; });
            return static_cast<double>(below) / static_cast<double>(values.size());
        };
        EXPECT_LE(quartiles.low, quartiles.middle);
        EXPECT_LE(quartiles.middle, quartiles.high);
        EXPECT_GE(share(quartiles.low), 0.25);
        EXPECT_GE(share(quartiles.middle), 0.5);
        EXPECT_GE(share(quartiles.high), 0.75);
        EXPECT_LT(share(quartiles.low - 1e-9), 0.25);
        EXPECT_LT(share(quartiles.high - 1e-9), 0.75);
    }
    EXPECT_EQ(quartiles_of({4, 1, 2, 3}).middle, 2);
}

TEST(Needed, TheSummaryCountsEveryPictureOnce) {
    const std::vector<double> values{2, 4, 8};
    NeededCurve enough_at_two{{0.6, 0.5, 0.6}, 8, 0.6}, at_eight{{0.1, 0.2, 0.4}, 8, 0.4}, blank{{0, 0, 0}, 8, 0};
    const NeededSummary summary = summary_of({enough_at_two, at_eight, blank}, values);
    EXPECT_EQ(summary.pictures, 3u);
    EXPECT_EQ(summary.nothing, 1u);
    EXPECT_EQ(summary.more, 1u);
    EXPECT_NEAR(summary.mean_f[0], 0.7 / 3, 1e-12);
    EXPECT_NEAR(summary.mean_f[2], 1.0 / 3, 1e-12);
    EXPECT_NEAR(summary.best_f, 1.0 / 3, 1e-12);
    EXPECT_EQ(summary.needed.middle, 2);
    EXPECT_EQ(summary.needed.high, 8);
    EXPECT_EQ(summary.own.middle, 8);
    EXPECT_EQ(summary_of({}, values).pictures, 0u);
}

}  // namespace
}  // namespace tactics::needed_test
