// SPDX-License-Identifier: Apache-2.0
#include "filters/kmeans_exact.h"

#include <gtest/gtest.h>

#include "filters/kmeans_iterative.h"
#include "tests/filters/pictures.h"

namespace tactics::kmeans_exact_test {
namespace {

using pictures::Chance;

std::vector<Level> levels(std::initializer_list<double> weights) {
    std::vector<Level> result;
    for (const double weight : weights) result.push_back({static_cast<double>(result.size()), weight});
    return result;
}

double squares_of_one_class(std::span<const Level> part) {
    double weight = 0;
    double mean = 0;
    for (const Level& level : part) weight += level.weight;
    if (weight <= 0) return 0;
    for (const Level& level : part) mean += level.value * level.weight / weight;
    double squares = 0;
    for (const Level& level : part) squares += level.weight * (level.value - mean) * (level.value - mean);
    return squares;
}

// The least over all ways to cut.
double brute_force(std::span<const Level> all, int k) {
    double least = squares_of_one_class(all);
    if (k == 1) return least;
    for (std::size_t cut = 1; cut < all.size(); ++cut)
        least = std::min(least, squares_of_one_class(all.first(cut)) + brute_force(all.subspan(cut), k - 1));
    return least;
}

double squares_around(std::span<const Level> all, const std::vector<double>& centres) {
    double total = 0;
    for (const Level& level : all) {
        double least = INFINITY;
        for (const double centre : centres) least = std::min(least, (level.value - centre) * (level.value - centre));
        total += level.weight * least;
    }
    return total;
}

TEST(KmeansExact, IsTheBestOfAllCuts) {
    Chance chance(1);
    for (int round = 0; round < 200; ++round) {
        std::vector<Level> all;
        double value = 0;
        for (int n = 1 + chance.below(11); n > 0; --n)
            all.push_back({value += 0.25 + chance.below(20), static_cast<double>(chance.below(4) == 0 ? 0 : chance.below(1000))});
        for (int k = 1; k <= 5; ++k) {
            const Classes classes = kmeans_exact(all, k);
            EXPECT_NEAR(classes.squares, brute_force(all, k), 1e-6) << "round " << round << ", k " << k;
            // What it says of itself is true.
            EXPECT_LE(classes.centres.size(), static_cast<std::size_t>(k));
            EXPECT_NEAR(classes.squares, classes.centres.empty() ? 0 : squares_around(all, classes.centres), 1e-6);
            double own = 0;
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (all[i].weight <= 0) continue;
                const double away = all[i].value - classes.centres[classes.class_of(i)];
                own += all[i].weight * away * away;
            }
            EXPECT_NEAR(classes.squares, own, 1e-6);
        }
    }
}

TEST(KmeansExact, HasAnAnswerWhereOthersHaveNone) {
    EXPECT_TRUE(kmeans_exact({}, 4).first.empty());
    EXPECT_TRUE(kmeans_exact(levels({0, 0, 0}), 4).first.empty());

    const Classes flat = kmeans_exact(levels({0, 0, 7, 0}), 4);
    EXPECT_EQ(flat.first, std::vector<std::size_t>({2}));
    EXPECT_EQ(flat.centres, std::vector<double>({2}));

    const Classes two = kmeans_exact(levels({5, 0, 0, 9}), 4);
    EXPECT_EQ(two.first, std::vector<std::size_t>({0, 3}));
    EXPECT_EQ(two.squares, 0);

    const Classes one = kmeans_exact(levels({1, 1, 4}), 1);
    EXPECT_EQ(one.first, std::vector<std::size_t>({0}));
    EXPECT_DOUBLE_EQ(one.centres[0], 1.5);
}

TEST(KmeansExact, TakesTheLowerBorderOfEqualOnes) {
    EXPECT_EQ(kmeans_exact(levels({1, 1, 1}), 2).first, std::vector<std::size_t>({0, 1}));
    EXPECT_EQ(kmeans_exact(levels({3, 0, 3, 0, 3}), 2).first, std::vector<std::size_t>({0, 2}));
}

TEST(KmeansExact, DoesNotDependOnHowManyPixelsThePictureHas) {
    Chance chance(2);
    std::vector<Level> small;
    for (int i = 0; i < 256; ++i) small.push_back({static_cast<double>(i), static_cast<double>(chance.below(1000))});
    std::vector<Level> large = small;
    for (Level& level : large) level.weight *= 4'000'000;  // 10^11 pixels and more
    for (int k = 1; k <= 16; ++k) EXPECT_EQ(kmeans_exact(small, k).first, kmeans_exact(large, k).first) << k;
}

// Counts like those of photographs: a few hills, some narrow.
std::vector<Level> hills(std::uint64_t seed) {
    Chance chance(seed);
    std::vector<double> weights(256, 1);
    for (int hill = 2 + chance.below(4); hill > 0; --hill) {
        const double middle = 255 * chance.unit();
        const double width = 2 + 40 * chance.unit() * chance.unit();
        const double height = 200 * chance.unit();
        for (int v = 0; v < 256; ++v)
            weights[static_cast<std::size_t>(v)] += height * std::exp(-(v - middle) * (v - middle) / (2 * width * width));
    }
    std::vector<Level> result;
    for (const double weight : weights) result.push_back({static_cast<double>(result.size()), std::floor(weight)});
    return result;
}

TEST(KmeansExact, IsNeverWorseThanTenRandomStarts) {
    int better = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const auto histogram = hills(seed);
        std::vector<float> samples;
        for (const Level& level : histogram)
            samples.insert(samples.end(), static_cast<std::size_t>(level.weight), static_cast<float>(level.value));
        for (const int k : {2, 4, 9, 16}) {
            const double exact = kmeans_exact(histogram, k).squares;
            const double iterative = squares_around(histogram, kmeans_iterative(samples, k, 10, seed));
            EXPECT_LE(exact, iterative * (1 + 1e-9)) << "seed " << seed << ", k " << k;
            better += exact < iterative * (1 - 1e-3) ? 1 : 0;
        }
    }
    EXPECT_GT(better, 0) << "the comparison is empty if the starts always find the best";
}

TEST(KmeansIterative, ChangesWithTheSeedAndNotWithoutIt) {
    const auto histogram = hills(3);
    std::vector<float> samples;
    for (const Level& level : histogram)
        samples.insert(samples.end(), static_cast<std::size_t>(level.weight), static_cast<float>(level.value));
    const auto first = kmeans_iterative(samples, 8, 1, 1);
    EXPECT_EQ(first, kmeans_iterative(samples, 8, 1, 1));
    bool changed = false;
    for (std::uint64_t seed = 2; seed < 6; ++seed) changed = changed || kmeans_iterative(samples, 8, 1, seed) != first;
    EXPECT_TRUE(changed);
}

TEST(KmeansIterative, GivesNoMoreCentresThanThereAreSamples) {
    EXPECT_TRUE(kmeans_iterative({}, 4, 3, 1).empty());
    EXPECT_EQ(kmeans_iterative(std::vector<float>(50, 7.0f), 4, 3, 1), std::vector<double>({7}));
    EXPECT_EQ(kmeans_iterative(std::vector<float>({3, 9, 3, 9, 9}), 4, 3, 1), std::vector<double>({3, 9}));
}

}  // namespace
}  // namespace tactics::kmeans_exact_test
