// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/fingertip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tactics/measure/random.h"

namespace tactics::fingertip_test {
namespace {

constexpr int kCells = 128;  // 64 mm: squares of exactly 8 mm

Relief blank() { return {kCells, 0.5, std::vector<float>(static_cast<std::size_t>(kCells) * kCells, 0.0f)}; }

template <typename Share>
Relief sheet_of(Share share) {
    Relief sheet = blank();
    for (int y = 0; y < kCells; ++y)
        for (int x = 0; x < kCells; ++x) sheet.raised[static_cast<std::size_t>(y * kCells + x)] = share(x, y);
    return sheet;
}

// Each square of 8 mm raised or not, by lot.
std::vector<Relief> patchworks(std::size_t count) {
    std::vector<Relief> sheets;
    for (std::size_t i = 0; i < count; ++i) {
        RandomNumbers random(i);
        const std::uint64_t raised = random.next();
        sheets.push_back(sheet_of([&](int x, int y) { return (raised >> (y / 16 * 8 + x / 16)) & 1 ? 1.0f : 0.0f; }));
    }
    return sheets;
}

FingertipReader sharp() {
    FingertipReader reader;
    reader.acuity = 0.5;
    reader.position_noise = 0;
    reader.places = 64;
    return reader;
}

double rate(const std::vector<Relief>& sheets, const FingertipReader& reader, int readers, std::uint64_t seed = 1) {
    const Answers answers = match_sheets(sheets, reader, readers, seed);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < answers.taken.size(); ++i) hits += answers.taken[i] == i % answers.sheets;
    EXPECT_EQ(answers.taken.size(), sheets.size() * static_cast<std::size_t>(readers));
    return static_cast<double>(hits) / static_cast<double>(answers.taken.size());
}

// R. G. Newcombe, Two-sided confidence intervals for the single proportion (1998), table I, method 3.
TEST(Wilson, GivesPublishedIntervals) {
    const auto expect = [](std::size_t hits, std::size_t trials, double low, double high) {
        const Interval interval = wilson(hits, trials);
        EXPECT_NEAR(interval.low, low, 5e-5) << hits << " of " << trials;
        EXPECT_NEAR(interval.high, high, 5e-5) << hits << " of " << trials;
    };
    expect(81, 263, 0.2553, 0.3662);
    expect(15, 148, 0.0624, 0.1605);
    expect(0, 20, 0, 0.1611);
    expect(1, 29, 0.0061, 0.1718);
    EXPECT_EQ(wilson(29, 29).high, 1);
    EXPECT_EQ(wilson(0, 0).high, 1);
}

TEST(Fingertip, WithoutErrorAndWithAllInMindEverySheetIsFoundAgain) {
    for (const double returning : {0.0, 1.0})
        for (const double edges : {0.0, 1.0}) {
            FingertipReader reader = sharp();
            reader.returning = returning;
            reader.edges = edges;
            EXPECT_EQ(rate(patchworks(12), reader, 5), 1) << returning << " " << edges;
        }
}

TEST(Fingertip, SheetsThatAreAlikeAreFoundByChance) {
    const std::vector<Relief> blanks(5, blank());
    const std::vector<Relief> copies(5, patchworks(1).front());
    for (const double returning : {0.0, 1.0}) {
        FingertipReader reader = sharp();
        reader.returning = returning;
        EXPECT_NEAR(rate(blanks, reader, 1000), 0.2, 0.025);
        EXPECT_NEAR(rate(copies, reader, 200), 0.2, 0.05);
        EXPECT_NEAR(rate(blanks, FingertipReader{}, 1000), 0.2, 0.025);
    }
    // Not the first of them, say.
    std::array<int, 5> times{};
    for (const std::uint16_t taken : match_sheets(blanks, FingertipReader{}, 1000, 1).taken) ++times.at(taken);
    for (const int one : times) EXPECT_NEAR(one, 1000, 120);
    EXPECT_TRUE(match_sheets({}, FingertipReader{}, 3, 1).taken.empty());
}

TEST(Fingertip, LessMemoryAndMoreErrorFindLess) {
    const auto sheets = patchworks(12);
    FingertipReader forgetful = sharp(), lost = sharp();
    forgetful.places = 6;
    lost.position_noise = 0.4;
    EXPECT_LT(rate(sheets, forgetful, 20), 0.9);
    EXPECT_LT(rate(sheets, lost, 20), 0.9);
    EXPECT_GT(rate(sheets, forgetful, 20), 0.1);
}

// A finger that feels the edge of the sheet is not lost beside it: one square raised of three that touch.
TEST(Fingertip, TheErrorGrowsWithTheDistanceFromTheEdges) {
    const auto sheets_at = [](int first) {
        const auto square = [&](int column, int row) {
            return sheet_of([=](int x, int y) { return x / 16 == first + column && y / 16 == first + row ? 1.0f : 0.0f; });
        };
        return std::vector<Relief>{square(0, 0), square(1, 0), square(0, 1)};
    };
    FingertipReader reader = sharp();
    reader.position_noise = 0.2;
    EXPECT_GT(rate(sheets_at(1), reader, 200), rate(sheets_at(3), reader, 200) + 0.1);
    EXPECT_NEAR(rate(sheets_at(3), reader, 200), rate(sheets_at(4), reader, 200), 0.15);  // beside the middle on either side
}

// Stripes of 0.5 mm and a surface half as high are one to a dull finger that feels changes of height.
TEST(Fingertip, WhatLiesCloserThanTheAcuityIsFeltAsOne) {
    const auto in_frame = [](auto share) {
        return sheet_of([=](int x, int y) { return x < 16 || y < 16 || x >= 112 || y >= 112 ? 0.0f : share(x); });
    };
    const std::vector<Relief> sheets{in_frame([](int x) { return x % 2 == 0 ? 1.0f : 0.0f; }),
                                     in_frame([](int) { return 0.5f; })};
    FingertipReader reader = sharp();
    reader.edges = 1;
    EXPECT_EQ(rate(sheets, reader, 50), 1);
    reader.acuity = 2.5;
    EXPECT_LT(rate(sheets, reader, 200), 0.65);
}

TEST(Fingertip, ASeedGivesTheSameAnswersAndAnotherGivesOthers) {
    const auto sheets = patchworks(12);
    const auto taken = [&](std::uint64_t seed) { return match_sheets(sheets, FingertipReader{}, 20, seed).taken; };
    EXPECT_EQ(taken(1), taken(1));
    EXPECT_NE(taken(1), taken(2));
}

TEST(Fingertip, SheetsOfOneSetHaveOneSize) {
    const Relief small{64, 1, std::vector<float>(64 * 64, 0.0f)};
    EXPECT_THROW(match_sheets({blank(), small}, FingertipReader{}, 1, 1), std::logic_error);
}

TEST(Fingertip, RandomReadersFillTheirRanges) {
    for (const ReaderRange& range : reader_ranges()) {
        double least = range.most, most = range.least;
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            const double value = range.get(random_reader(seed));
            EXPECT_GE(value, range.least) << range.name.text;
            EXPECT_LE(value, range.most) << range.name.text;
            least = std::min(least, value);
            most = std::max(most, value);
        }
        EXPECT_GT(most - least, 0.9 * (range.most - range.least)) << range.name.text;
        const double usual = range.get(FingertipReader{});
        EXPECT_TRUE(usual >= range.least && usual <= range.most) << range.name.text;
    }
}

}  // namespace
}  // namespace tactics::fingertip_test
