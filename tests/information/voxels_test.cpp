// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/voxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "tactics/error.h"

namespace tactics::voxels_test {
namespace {

ForceField field(int columns, int rows, int slices, const std::function<Point3(int x, int y, int z)>& force) {
    ForceField made{columns, rows, slices, 1, {}};
    for (int z = 0; z < slices; ++z)
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) made.forces.push_back(force(x, y, z));
    return made;
}

TEST(Voxels, FiveEachWayOf256LevelsAreAThousandBits) {
    std::mt19937 random(1);
    const auto noise = field(5, 5, 5, [&](int, int, int) { return Point3{static_cast<double>(random() % 256), 0, 0}; });
    const MeasuredVoxels told = measured(noise, {1, 0, 255, 256}, false, "noise");
    EXPECT_EQ(told.raw, 1000);
    EXPECT_LE(told.high, 1000);
    EXPECT_TRUE(told.details.empty());
}

TEST(Voxels, AWallTellsLittleAndNoiseAll) {
    std::mt19937 random(2);
    const auto wall = field(16, 16, 16, [](int x, int, int) { return Point3{x < 7 ? 0.0 : 255.0, 0, 0}; });
    const auto noise = field(16, 16, 16, [&](int, int, int) { return Point3{static_cast<double>(random() % 256), 0, 0}; });
    const VoxelLevels bytes{1, 0, 255, 256};
    EXPECT_LT(measured(wall, bytes, false, "wall").high, 0.02 * measured(wall, bytes, false, "wall").raw);
    EXPECT_GT(measured(noise, bytes, false, "noise").high, 0.98 * 8 * 16 * 16 * 16);
}

// Between voxels a field is trilinear, so that of one that is so everywhere fewer tell all.
TEST(Voxels, WhatIsTrilinearIsThereInFewerVoxels) {
    const auto slope = field(17, 9, 5, [](int x, int y, int z) { return Point3{x + 2.0 * y, 0.5 * x * y, x * y * z / 100.0}; });
    const MeasuredVoxels told = measured(slope, {3, -100, 100, 65535}, true, "slope");
    ASSERT_EQ(told.along.size(), 3u);
    ASSERT_EQ(told.details.size(), 5u);
    EXPECT_EQ(told.details[1].columns, 9);
    EXPECT_EQ(told.details[1].rows, 5);
    EXPECT_EQ(told.details[1].slices, 3);
    EXPECT_EQ(told.details.back().columns, 2);
    EXPECT_EQ(told.details.back().slices, 2);
    for (std::size_t i = 1; i < told.details.size(); ++i) {
        EXPECT_NEAR(told.details[i].error, 0, 1e-9) << i;
        EXPECT_LE(told.details[i].bits, told.details[i - 1].bits);
    }
    const auto bumpy = field(17, 9, 5, [](int x, int y, int z) { return Point3{(x + y + z) % 2 == 0 ? 9.0 : 0.0, 0, 0}; });
    EXPECT_GT(measured(bumpy, {1, 0, 255, 256}, true, "bumpy").details[1].error, 1);
}

TEST(Voxels, OneSliceAndOneColumnAreMeasured) {
    const auto flat = field(9, 1, 1, [](int x, int, int) { return Point3{static_cast<double>(x), 0, 0}; });
    EXPECT_NEAR(measured(flat, {1, 0, 255, 256}, true, "flat").details.back().error, 0, 1e-9);
    const auto high = field(1, 1, 9, [](int, int, int z) { return Point3{static_cast<double>(z), 0, 0}; });
    EXPECT_NEAR(measured(high, {1, 0, 255, 256}, true, "high").details.back().error, 0, 1e-9);
    EXPECT_THROW(measured(field(3, 3, 3, [](int, int, int) { return Point3{1, 0, 0}; }), {}, true, "even"), Error);
}

}  // namespace
}  // namespace tactics::voxels_test
