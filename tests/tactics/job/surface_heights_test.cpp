// SPDX-License-Identifier: Apache-2.0
// A surface as heights: where its samples are, how high they are, and what is not known.
#include "tactics/job/surface_heights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tactics/error.h"

namespace tactics::surface_heights_test {
namespace {

// A plane that rises to the right and upwards, unevenly sampled: bilinear heights are exact on it.
PlotSurface plane() {
    PlotSurface surface{"", {0, 1, 3, 10}, {0, 4, 5}, {}};
    for (const double y : surface.y)
        for (const double x : surface.x) surface.z.push_back(2 * x + 3 * y);
    return surface;
}

TEST(SurfaceHeights, AreThoseOfThePlaneSeenFromAbove) {
    HeightWish wish;
    wish.width = 100;
    wish.pitch = 1;
    wish.low = 1;
    wish.high = 6;
    const HeightFile file = surface_heights(plane(), wish);
    ASSERT_EQ(file.map.columns, 100);
    ASSERT_EQ(file.map.rows, 50) << "in proportion: 10 by 5";
    EXPECT_TRUE(file.notes.empty());
    for (int row = 0; row < file.map.rows; ++row)
        for (int column = 0; column < file.map.columns; ++column) {
            const double x = (column + 0.5) / 10, y = 5 - (row + 0.5) / 10;
            ASSERT_NEAR(static_cast<double>(file.map.at(column, row)), 1 + 5 * (2 * x + 3 * y) / 35, 1e-4);
        }
    wish.invert = true;
    const HeightFile mould = surface_heights(plane(), wish);
    EXPECT_NEAR(static_cast<double>(mould.map.at(3, 4)) + static_cast<double>(file.map.at(3, 4)), 7, 1e-4);
}

TEST(SurfaceHeights, WhatIsNotKnownIsLowAndTold) {
    PlotSurface surface = plane();
    surface.z[5] = NAN;
    const HeightFile file = surface_heights(surface, {});
    ASSERT_EQ(file.notes.size(), 1u);
    EXPECT_EQ(file.notes[0].english().substr(0, 18), "1 of its heights a");
    for (const float height : file.map.heights) EXPECT_TRUE(height >= 0 && height <= 10);
    surface.z.assign(surface.z.size(), NAN);
    EXPECT_THROW(surface_heights(surface, {}), Error);
    HeightWish fine;
    fine.pitch = 1e-4;
    EXPECT_THROW(surface_heights(plane(), fine), Error);
    fine = {};
    fine.high = -1;
    EXPECT_THROW(surface_heights(plane(), fine), Error);
}

TEST(SurfaceHeights, OtherKindsOfXAndYAreNoSliver) {
    PlotSurface surface = plane();
    for (double& y : surface.y) y *= 1e6;
    const HeightFile file = surface_heights(surface, {});
    EXPECT_NEAR(file.map.height() / file.map.width(), 4, 0.05);
}

}  // namespace
}  // namespace tactics::surface_heights_test
