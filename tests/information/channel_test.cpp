// SPDX-License-Identifier: Apache-2.0
// Equations 3 to 5 of the paper and its claims about media.
#include "tactics/information/channel.h"

#include <gtest/gtest.h>

#include <set>

#include "print/format.h"
#include "tactics/error.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/information/code_length.h"
#include "tactics/information/least_loss.h"
#include "tactics/information/media.h"
#include "tests/information/sources.h"

namespace tactics::tests::channel_test {
namespace {

MediumChannel named(const std::string& name) { return named_channels(name, {}, "--media").front(); }

MeasuredScene relief(int columns, int rows, int levels, std::uint64_t seed) {
    return scene_of(terrain(columns, rows, levels, seed), 0.25, 0, 10, "relief");
}

TEST(Channel, CarriesNoMoreThanItHoldsOrThereIs) {
    MeasuredScene scene = relief(320, 240, 256, 1);
    for (const MediumChannel& channel : channels({})) {
        const Carried carried = carried_by(scene, channel);
        EXPECT_LE(carried.bits, carried.capacity) << channel.name;
        EXPECT_LE(carried.bits, scene.measures.bits) << channel.name;
        EXPECT_GT(carried.bits, 0) << channel.name;
        EXPECT_DOUBLE_EQ(carried.ratio, carried.bits / scene.measures.bits);
        EXPECT_DOUBLE_EQ(carried.loss, 1 - carried.ratio);
        EXPECT_EQ(carried.lost.empty(), carried.loss == 0) << channel.name;
    }
}

TEST(Channel, LossFallsWithResolutionAndWithLevels) {
    MeasuredScene scene = relief(320, 240, 256, 2);
    double before = 1.1;
    for (double pitch = 8; pitch > 0.3; pitch /= 1.3) {
        const double loss = carried_by(scene, {.width = 250, .height = 180, .pitch = pitch, .levels = 16}).loss;
        EXPECT_LE(loss, before) << pitch;
        before = loss;
    }
    EXPECT_LT(before, 0.8);
    before = 1.1;
    for (const int levels : {2, 3, 4, 5, 8, 16, 31, 64, 100, 256}) {
        const double loss = carried_by(scene, {.width = 250, .height = 180, .pitch = 0.5, .levels = levels}).loss;
        EXPECT_LE(loss, before) << levels;
        before = loss;
    }
    EXPECT_EQ(before, 0);
}

// "HIL_O will be always higher or equal to HIL_D" (section 4).
TEST(Channel, TheOmniLosesAtLeastWhatTheDesktopLoses) {
    const MediumChannel omni = named("omni"), desktop = named("desktop");
    ASSERT_GT(omni.pitch, desktop.pitch);
    RandomNumbers random(11);
    int unequal = 0;
    for (int i = 0; i < 30; ++i) {
        const int columns = 1 + static_cast<int>(random.below(120)), rows = 2 + static_cast<int>(random.below(90));
        const int levels = 2 << random.below(12);
        const LevelGrid grid = i % 3 == 0   ? noise(columns, rows, levels, random.next())
                               : i % 3 == 1 ? terrain(columns, rows, levels, random.next())
                                            : wall(columns + 3, rows, levels);
        // As fine as the paper's 0.01 mm, or coarser; on the whole workspace or not; flat or high.
        MeasuredScene scene = scene_of(grid, 0.01 * std::exp2(8 * random.uniform()), 0, 0.2 + 120 * random.uniform(), "scene");
        MediumChannel first = omni, second = desktop;
        if (i % 2 == 0)
            first.width = first.height = second.width = second.height = columns * 0.03;  // smaller than the scene has places
        const double lost = carried_by(scene, first).loss, least = carried_by(scene, second).loss;
        EXPECT_GE(lost, least) << i;
        unequal += lost > least;
    }
    EXPECT_GT(unequal, 5);
}

TEST(Channel, MediaAreWhatTheTreeSaysOfThem) {
    EXPECT_EQ(named("graphiti").levels, 5);
    EXPECT_EQ(named("graphiti").width, 150);
    EXPECT_EQ(named("viewplus").pitch, 1.27);
    EXPECT_EQ(named("omni").pitch, kArms[0].arm.resolution);
    EXPECT_NEAR(named("swell").pitch, 25.4 / 150, 1e-12);
    EXPECT_NEAR(named("embosser").pitch, std::sqrt(3 * 10.0 / 3), 1e-12);  // 2 x 3 dots in 6 x 10 mm
    std::set<std::string> names;
    for (const MediumChannel& channel : channels({})) {
        EXPECT_TRUE(names.insert(channel.name).second) << channel.name;
        EXPECT_GT(channel.pitch, 0) << channel.name;
    }
    for (const Medium& medium : media()) EXPECT_TRUE(names.contains(std::string(medium.name)));
    for (const Format* format : formats())
        EXPECT_TRUE(format->embosser == nullptr || names.contains(std::string(format->name))) << format->name;
    for (const char* device : {"mouse", "omni", "desktop", "phantom", "heightmap", "stl"}) EXPECT_TRUE(names.contains(device));
}

TEST(Channel, NamesAreReadAndMisspellingsTold) {
    EXPECT_EQ(named_channels("omni,swell", {}, "--media").size(), 2u);
    EXPECT_EQ(named_channels("all", {}, "--media").size(), channels({}).size());
    EXPECT_THROW(
        try { named_channels("grafiti", {}, "--media"); } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("--media: there is no medium \"grafiti\" (graphiti?)"), std::string::npos)
                << error.what();
            throw;
        },
        Error);
    EXPECT_THROW(named_channels("omni,", {}, "--media"), Error);
    EXPECT_GT(named_channels("swell", find_paper("a3", ""), "").front().width, named("swell").width);
}

TEST(Channel, OfADrawingTheLinesThatAFingerConfusesAreTold) {
    Drawing lines{100, 100, {}, {}, {}};
    for (const double x : {50.0, 51.0, 52.0}) lines.strokes.push_back({{{x, 0}, {x, 100}}});
    lines.strokes.push_back({{{10, 10}, {11, 10}}});
    const LevelGrid grid = grid_by(100, 100, 2, [](int x, int) { return x >= 50 && x < 53; });
    MeasuredScene scene = scene_of(grid, 1, lines, "lines");
    const MediumChannel close{.width = 100, .height = 100, .pitch = 1, .least_apart = 4, .shortest = 5};
    const std::vector<std::string> lost = in_language(carried_by(scene, close).lost, "en");
    ASSERT_EQ(lost.size(), 2u);
    EXPECT_NE(lost[0].find("lines closer than 4 mm ("), std::string::npos) << lost[0];
    EXPECT_EQ(lost[1], "lines shorter than 5 mm (1 of 4)");
    const MediumChannel far{.width = 1000, .height = 1000, .pitch = 1, .least_apart = 4, .shortest = 5};
    EXPECT_TRUE(carried_by(scene, far).lost.empty());
}

TEST(Channel, WhatHasNothingToFeelIsRefused) {
    const LevelGrid flat = grid_by(20, 20, 256, [](int, int) { return 7; });
    EXPECT_THROW(scene_of(flat, 1, 0, 10, "flat.png"), Error);
    EXPECT_THROW(scene_of(flat, 1, Drawing{}, "flat.svg"), Error);
    EXPECT_THROW(scene_of({1, 1, 1, 256, {9}}, 1, 0, 10, "dot.png"), Error);
}

// The search is bounded, and what it finds loses what it says and no more than the filter by itself.
TEST(LeastLoss, IsNeverMoreThanThePlainOneAndCanBeMadeAgain) {
    for (std::uint64_t seed = 1; seed < 5; ++seed) {
        MeasuredScene scene = relief(160, 120, 256, seed);
        for (const char* name : {"graphiti", "viewplus", "embosser", "omni"}) {
            const MediumChannel channel = named(name);
            const LeastLoss least = least_loss(scene, channel);
            EXPECT_LE(least.loss, least.plain) << name;
            EXPECT_LE(least.tried, 30u);
            if (least.loss == least.plain) continue;
            const LevelGrid made = transformed(scene, least.best, carried_by(scene, channel).fit.levels);
            Pyramid again(made, Pooling::mean);
            EXPECT_NEAR(std::max(0.0, 1 - again.bits(1000, made.levels) / scene.measures.bits), least.loss, 1e-9) << name;
        }
    }
    // Most of it low and flat: where each level is used, more comes through.
    const LevelGrid low = grid_by(160, 120, 256, [](int x, int y) { return 10 + (x * y) % 30 / 5 + (x == 5 ? 240 : 0); });
    MeasuredScene scene = scene_of(low, 1, 0, 10, "low");
    EXPECT_LT(least_loss(scene, named("graphiti")).loss, least_loss(scene, named("graphiti")).plain);
}

// Strips choose, but what is told is of the whole.
TEST(LeastLoss, OfALargeSceneItIsThatOfTheWhole) {
    MeasuredScene scene = scene_of(
        grid_by(1000, 1200, 256, [](int x, int y) { return 10 + (x * y) % 30 / 5 + (x == 5 ? 240 : 0); }), 1, 0, 10, "large");
    const MediumChannel fine{.width = 2000, .height = 2000, .pitch = 1, .levels = 5};
    const LeastLoss least = least_loss(scene, fine);
    ASSERT_LT(least.loss, least.plain);
    const Carried plain = carried_by(scene, fine);
    const double code = code_length(transformed(scene, least.best, plain.fit.levels)).best.bits, all = scene.measures.bits;
    EXPECT_NEAR(least.loss, std::max(0.0, all - std::min(plain.capacity, code)) / all, 1e-12);
}

TEST(LeastLoss, ItsHeightsLieInTheMiddleOfTheirLevels) {
    MeasuredScene scene = relief(160, 120, 256, 3);
    const HeightMap map = transformed_heights(scene, {80, 0, 0.5}, 5);
    EXPECT_EQ(map.columns, 80);
    EXPECT_EQ(map.rows, 60);
    EXPECT_DOUBLE_EQ(map.width(), scene.width);
    const double step = (scene.high - scene.low) / 5;
    std::set<double> heights(map.heights.begin(), map.heights.end());
    EXPECT_LE(heights.size(), 5u);
    for (const double height : heights) {
        const double level = (height - scene.low) / step - 0.5;
        EXPECT_NEAR(level, std::round(level), 1e-5) << height;
    }
}

TEST(LeastLoss, HeightsKeepTheirOrder) {
    MeasuredScene scene = relief(160, 120, 256, 3);
    const LevelGrid plain = transformed(scene, {160, 0, 0}, 256), evened = transformed(scene, {160, 0, 1}, 16);
    for (std::size_t i = 1; i < plain.count(); ++i)
        EXPECT_TRUE(plain.values[i] < plain.values[i - 1] || evened.values[i] >= evened.values[i - 1]) << i;
    EXPECT_NEAR(entropy_of(evened).plug_in, 4, 0.05);  // each of 16 levels as often as the others
}

}  // namespace
}  // namespace tactics::tests::channel_test
