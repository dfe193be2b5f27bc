// SPDX-License-Identifier: Apache-2.0
// Sources of which the entropy is known: it lies within the interval, and the interval says something.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tactics/information/measures.h"
#include "tests/information/sources.h"

namespace tactics::tests::known_entropy_test {
namespace {

// How values follow: each by so many before it. As one line, or in rows that each begin anew.
class Chain {
public:
    Chain(int levels, int order, double sharpness, std::uint64_t seed) : levels_(levels), random_(seed) {
        std::size_t contexts = 1;
        for (int i = 0; i < order; ++i) contexts *= static_cast<std::size_t>(levels);
        for (std::size_t context = 0; context < contexts; ++context) {
            std::vector<double> shares;
            double sum = 0;
            for (int i = 0; i < levels; ++i) sum += shares.emplace_back(std::pow(random_.uniform(), sharpness) + 1e-4);
            for (double& share : shares) share /= sum;
            shares_.push_back(std::move(shares));
        }
        settle();
    }

    double bits_a_value() const { return bits_a_value_; }

    // `anew` is for chains of the first order: the first value of a row is as any, and hangs on none.
    double bits_of(int columns, int rows, bool anew) const {
        double first = 0;
        for (const double share : often_) first -= share > 0 ? share * std::log2(share) : 0;
        return anew ? rows * (first + (columns - 1) * bits_a_value_) : bits_a_value_ * columns * rows;
    }

    LevelGrid draw(int columns, int rows, bool anew) {
        const std::size_t contexts = shares_.size();
        std::size_t context = drawn(often_);
        return grid_by(columns, rows, levels_, [&](int x, int) {
            if (anew && x == 0) context = drawn(often_);
            const std::size_t value = drawn(shares_[context]);
            context = (context * static_cast<std::size_t>(levels_) + value) % contexts;
            return static_cast<int>(value);
        });
    }

private:
    std::size_t drawn(const std::vector<double>& shares) {
        double at = random_.uniform();
        for (std::size_t i = 0; i + 1 < shares.size(); ++i)
            if ((at -= shares[i]) < 0) return i;
        return shares.size() - 1;
    }

    // How often each context is there in the long run.
    void settle() {
        const std::size_t contexts = shares_.size(), levels = static_cast<std::size_t>(levels_);
        often_.assign(contexts, 1.0 / static_cast<double>(contexts));
        for (int round = 0; round < 400; ++round) {
            std::vector<double> next(contexts);
            for (std::size_t context = 0; context < contexts; ++context)
                for (std::size_t i = 0; i < levels; ++i)
                    next[(context * levels + i) % contexts] += often_[context] * shares_[context][i];
            often_ = std::move(next);
        }
        for (std::size_t context = 0; context < contexts; ++context)
            for (const double share : shares_[context]) bits_a_value_ -= often_[context] * share * std::log2(share);
    }

    int levels_;
    RandomNumbers random_;
    std::vector<std::vector<double>> shares_;
    std::vector<double> often_;
    double bits_a_value_ = 0;
};

struct Held {
    int all = 0, held = 0;
    double width = 0;  // of the interval, by what is written; the sum of all
    std::string missed;
};

void hold(Held& held, const LevelGrid& grid, double known, const std::string& what) {
    const Measures measures = measure(grid, {});
    ++held.all;
    held.width += (measures.high - measures.low) / measures.raw;
    EXPECT_LE(measures.low, 1.02 * known) << what;
    EXPECT_GE(measures.high, 0.98 * known) << what;
    EXPECT_LE(measures.low, measures.bits) << what;
    EXPECT_LE(measures.high, measures.raw + 1e-6) << what;
    if (measures.low <= known && known <= measures.high)
        ++held.held;
    else
        held.missed += what + ": " + std::to_string(measures.low / known) + " to " + std::to_string(measures.high / known) + "\n";
}

LevelGrid turned(const LevelGrid& grid) {
    return grid_by(grid.rows, grid.columns, grid.levels, [&](int x, int y) {
        return grid.values[static_cast<std::size_t>(x) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(y)];
    });
}

void hold_chains(int order, int columns, int rows, bool anew, double most_width) {
    Held held;
    for (const int levels : {2, 3, 4, 5, 6, 8, 11, 16})
        for (const double sharpness : {0.5, 2.0, 6.0})
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                Chain chain(levels, order, sharpness, seed * 1000 + static_cast<std::uint64_t>(levels));
                const LevelGrid grid = chain.draw(columns, rows, anew);
                hold(held, seed == 3 && rows > 1 ? turned(grid) : grid, chain.bits_of(columns, rows, anew),
                     std::to_string(levels) + " levels, sharpness " + std::to_string(sharpness) + ", seed " +
                         std::to_string(seed));
            }
    // Three standard deviations leave out one of 370.
    EXPECT_GE(held.held, held.all - 1) << held.missed;
    EXPECT_LT(held.width / held.all, most_width);
}

TEST(KnownEntropy, OfIndependentValuesIsHeld) { hold_chains(0, 300, 200, false, 0.04); }
TEST(KnownEntropy, OfChainsIsHeld) { hold_chains(1, 300, 200, false, 0.06); }
TEST(KnownEntropy, OfChainsThatBeginAnewInEachRowIsHeld) { hold_chains(1, 40, 1500, true, 0.06); }
TEST(KnownEntropy, OfChainsOfTheSecondOrderIsHeld) { hold_chains(2, 300, 200, false, 0.15); }
TEST(KnownEntropy, OfChainsInASingleRowIsHeld) { hold_chains(1, 40'000, 1, false, 0.08); }
TEST(KnownEntropy, OfChainsOfTheSecondOrderInASingleRowIsHeld) { hold_chains(2, 40'000, 1, false, 0.2); }
TEST(KnownEntropy, OfFewValuesIsHeld) { hold_chains(1, 40, 30, false, 0.8); }

// What stays long in a state says little, and what it says comes seldom.
TEST(KnownEntropy, OfWhatSeldomChangesIsHeld) {
    Held held;
    for (const double stay : {0.6, 0.9, 0.99, 0.999})
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            RandomNumbers random(seed);
            std::size_t state = 0;
            const LevelGrid grid = grid_by(700, 500, 4, [&](int, int) {
                if (random.uniform() >= stay) state = (state + 1 + random.below(3)) % 4;
                return static_cast<int>(state);
            });
            const double known = -stay * std::log2(stay) - (1 - stay) * std::log2((1 - stay) / 3);
            const Measures measures = measure(grid, {});
            ++held.all;
            const bool holds = measures.low <= known * 350'000 && known * 350'000 <= measures.high;
            held.held += holds;
            if (!holds) held.missed += std::to_string(stay) + "\n";
            EXPECT_NEAR(measures.alone.corrected, 2, 0.1);  // its levels alone hide it
        }
    EXPECT_EQ(held.held, held.all) << held.missed;
}

TEST(KnownEntropy, OfACheckerboardIsNone) {
    for (const int size : {1, 2, 3, 8, 16, 30})
        for (const int side : {64, 256, 500}) {
            const LevelGrid board = grid_by(side, side, 256, [&](int x, int y) { return (x / size + y / size) % 2 * 255; });
            const Measures measures = measure(board, {});
            EXPECT_EQ(measures.low, 0) << size;
            EXPECT_LT(measures.high, 0.06 * side * side) << size;
        }
}

// Large ones, too, of which other grids are counted by bands of rows.
TEST(KnownEntropy, OfALargeCheckerboardIsNone) {
    for (const int columns : {3000, 4000}) {
        const LevelGrid board = grid_by(columns, 3000, 256, [&](int x, int y) { return (x / 8 + y / 8) % 2 * 255; });
        EXPECT_EQ(measure(board, {}).low, 0) << columns;
    }
}

// Blocks of equal cells hold what one cell of each does, and no more.
TEST(KnownEntropy, OfAnEnlargedGridIsThatOfTheSmallOne) {
    for (const int times : {2, 5, 20}) {
        const LevelGrid small = noise(100, 50, 2, 3);
        const LevelGrid large = grid_by(100 * times, 50 * times, 2, [&](int x, int y) {
            return small.values[static_cast<std::size_t>(y / times * 100 + x / times)];
        });
        const Measures measures = measure(large, {});
        EXPECT_LE(measures.low, 5000) << times;
        EXPECT_GE(measures.low, 4500) << times;
        EXPECT_GE(measures.high, 5000) << times;
        EXPECT_LE(measures.high, 5500) << times;
    }
}

// Cut at its edges it is still an enlarged one.
TEST(KnownEntropy, OfAnEnlargedGridThatIsCutIsHeld) {
    for (const int times : {3, 11}) {
        const LevelGrid small = noise(90, 60, 4, 7);
        const LevelGrid large = grid_by(90 * times - 2, 60 * times - 2, 4, [&](int x, int y) {
            return small.values[static_cast<std::size_t>((y + 1) / times * 90 + (x + 1) / times)];
        });
        const Measures measures = measure(large, {});
        EXPECT_LE(measures.low, 2 * 5400) << times;
        EXPECT_GE(measures.high, 2 * 5400) << times;
        EXPECT_LE(measures.high, 2.2 * 5400) << times;
    }
}

// Wherever stripes run to, they tell nothing, and of tiles all are as the first.
TEST(KnownEntropy, OfWhatRepeatsIsThatOfOnce) {
    for (const int width : {3, 20, 57}) {
        const Measures slanting = measure(grid_by(401, 389, 3, [&](int x, int y) { return (3 * x + 2 * y) / width % 3; }), {});
        EXPECT_EQ(slanting.low, 0) << width;
        EXPECT_LT(slanting.high, 1500) << width;
    }
    const LevelGrid tile = noise(67, 41, 16, 2);
    const Measures tiled = measure(
        grid_by(500, 400, 16, [&](int x, int y) { return tile.values[static_cast<std::size_t>(y % 41 * 67 + x % 67)]; }), {});
    EXPECT_LE(tiled.low, 67 * 41 * 4);
    EXPECT_GE(tiled.low, 66 * 40 * 4);
    EXPECT_GE(tiled.high, 67 * 41 * 4);
    EXPECT_LT(tiled.high, 68 * 42 * 4);
}

// Chains of many levels that run along rows or down columns: there is room for one neighbour only, the right one.
TEST(KnownEntropy, OfStepsOfManyLevelsIsHeldWhicheverWayTheyRun) {
    RandomNumbers random(11);
    std::vector<int> last(400);
    for (int& value : last) value = static_cast<int>(random.next() % 256);
    std::vector<std::uint16_t> down;
    for (int y = 0; y < 400; ++y)
        for (int& value : last)
            down.push_back(static_cast<std::uint16_t>(value = (value + 255 + static_cast<int>(random.next() % 3)) % 256));
    const double bits = 400 * 8 + 399 * 400 * std::log2(3);
    for (const bool along : {false, true}) {
        const Measures measures =
            measure(grid_by(400, 400, 256,
                            [&](int x, int y) { return down[static_cast<std::size_t>(along ? x * 400 + y : y * 400 + x)]; }),
                    {});
        EXPECT_LE(measures.low, bits) << along;
        EXPECT_GE(measures.high, bits) << along;
        EXPECT_LT(measures.high, 1.4 * bits) << along;  // what is seldom seen costs its learning
    }
}

// Wide ones are counted by part of their rows, too.
TEST(KnownEntropy, OfAWideGridIsHeldByAPartOfItsRows) {
    const Measures measures = measure(noise(6000, 1000, 16, 3), {});
    EXPECT_LT(measures.counted, 0.3);
    EXPECT_LE(measures.low, 24e6);
    EXPECT_GE(measures.high, 24e6 - 1);
}

// A strip of faint chance between steps that are great, but foretold: bands of rows must not pass it by.
TEST(KnownEntropy, AStripOfChanceInALargeBoardIsFound) {
    for (const int top : {333, 517}) {
        RandomNumbers random(static_cast<std::uint64_t>(top));
        const LevelGrid grid = grid_by(2000, 2000, 256, [&](int x, int y) {
            const bool other = random.uniform() < 1e-4;
            const int board = ((x + y) % 2 == 1) != other ? 252 : 0;
            return y >= top && y < top + 12 ? board + static_cast<int>(random.below(4)) : board;
        });
        const Measures measures = measure(grid, {});
        EXPECT_GT(measures.high, 12 * 2000 * 2) << top;
        EXPECT_LT(measures.low, 1.05 * (12 * 2000 * 2 + 5893)) << top;  // two sources side by side (measures.h)
    }
}

// Nine million cells, of which a part of the rows is counted.
TEST(KnownEntropy, OfALargeGridIsHeldByAPartOfItsRows) {
    Chain chain(12, 1, 2.0, 5);
    Held held;
    hold(held, chain.draw(3000, 3000, false), chain.bits_a_value() * 9e6, "a chain");
    hold(held, noise(3000, 3000, 200, 3), 9e6 * std::log2(200), "noise");
    EXPECT_EQ(held.held, held.all) << held.missed;
    EXPECT_LT(held.width / held.all, 0.02);
    EXPECT_LT(measure(noise(3000, 3000, 200, 3), {}).counted, 0.7);
}

// A few things on an empty sheet may lie between the rows that are counted, so all are.
TEST(KnownEntropy, NothingIsMissedOnALargeGridThatIsNearlyEmpty) {
    RandomNumbers random(1);
    const LevelGrid grid = grid_by(
        3000, 3000, 256, [&](int x, int y) { return y > 801 && y < 804 && x > 100 ? static_cast<int>(random.below(256)) : 255; });
    const Measures measures = measure(grid, {});
    EXPECT_EQ(measures.counted, 1);
    EXPECT_GT(measures.bits, 2 * 2899 * 8.0);
}

// Lines over the full width differ from nothing to their left.
TEST(KnownEntropy, NoLineOverTheFullWidthIsMissed) {
    const LevelGrid grid = grid_by(2000, 4000, 256, [](int, int y) { return y % 1000 == 801 + y / 1000 ? 0 : 255; });
    const Measures measures = measure(grid, {});
    EXPECT_EQ(measures.counted, 1);
    EXPECT_GT(measures.bits, 30);
}

// What the bands say of the whole is what the whole says.
TEST(KnownEntropy, ALargeTerrainIsAsItsRowsTell) {
    const LevelGrid small = terrain(2000, 1000, 256, 6);
    const LevelGrid large = repeated(small, 2, false);
    const Measures one = measure(small, {}), both = measure(large, {});
    ASSERT_EQ(one.counted, 1);
    ASSERT_LT(both.counted, 1);
    EXPECT_NEAR(both.bits, 2 * one.bits, 0.02 * both.bits);
    EXPECT_LE(both.low, 2 * one.bits);
    EXPECT_GE(both.high, 2 * one.bits);
}

}  // namespace
}  // namespace tactics::tests::known_entropy_test
