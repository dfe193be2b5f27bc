// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/grid.h"

#include <gtest/gtest.h>

#include <limits>

#include "tactics/error.h"
#include "tests/information/sources.h"

namespace tactics::tests::grid_test {
namespace {

TEST(InformationGrid, HeightsFallIntoTheirLevels) {
    const HeightMap map{4, 1, 1, {0, 2.4f, 9.99f, 10}};
    EXPECT_EQ(grid_of(map, 0, 10, 4, "a").values, (Cells{0, 0, 3, 3}));
    EXPECT_EQ(grid_of(map, 2, 3, 2, "a").values, (Cells{0, 0, 1, 1}));  // cut
}

TEST(InformationGrid, WhatCannotBeCountedIsRefusedWithItsName) {
    const HeightMap hole{2, 1, 1, {0, std::numeric_limits<float>::quiet_NaN()}}, empty{};
    EXPECT_THROW(
        try { grid_of(hole, 0, 1, 4, "hole.tif"); } catch (const Error& error) {
            EXPECT_STREQ(error.what(), "hole.tif: one of its values is not a number, so nothing can be counted; mend the file");
            throw;
        },
        Error);
    EXPECT_THROW(grid_of(empty, 0, 1, 4, "a"), Error);
    const Point3 bad[] = {{0, std::numeric_limits<double>::infinity(), 0}};
    EXPECT_THROW(component_of(bad, 0, 1, 4, "a"), Error);
    EXPECT_THROW(component_of(std::span<const Point3>(), 0, 1, 4, "a"), Error);
    EXPECT_THROW(check_grid({2, 2, 1, 4, {0, 1, 2}}), std::logic_error);
    EXPECT_THROW(check_grid({2, 2, 1, 4, {0, 1, 2, 4}}), std::logic_error);
    EXPECT_NO_THROW(check_grid({1, 1, 1, kMostLevels, {65535}}));
}

// Halving twice is quartering: what has fewer levels is a function of what has more.
TEST(InformationGrid, FewerLevelsAreNested) {
    const LevelGrid grid = noise(64, 64, 256, 5);
    EXPECT_EQ(with_levels(with_levels(grid, 64), 16).values, with_levels(grid, 16).values);
    EXPECT_EQ(with_levels(grid, 300).values, grid.values);
    const LevelGrid five = with_levels(grid, 5);
    const std::vector<std::uint16_t> words = words_of(five);
    EXPECT_EQ(*std::max_element(words.begin(), words.end()), 4);
}

// Trilinear interpolation gives every field back that is linear in each of x, y and z.
TEST(InformationGrid, ForcesBetweenVoxelsAreTrilinear) {
    const auto force = [](double x, double y, double z) { return Point3{1 + 2 * x - y + 0.5 * z, x * y * z, 3 - y * z}; };
    ForceField field{5, 4, 3, 2.0, {}};
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 5; ++i) field.forces.push_back(force(2.0 * i, 2.0 * j, 2.0 * k));
    RandomNumbers random(3);
    for (int i = 0; i < 100; ++i) {
        const Point3 at{8 * random.uniform(), 6 * random.uniform(), 4 * random.uniform()};
        EXPECT_LT(length_of(field.at(at) - force(at.x, at.y, at.z)), 1e-9);
    }
    EXPECT_LT(length_of(field.at({-5, 2, 99}) - force(0, 2, 4)), 1e-12);  // the nearest place inside
    const ForceField finer = resampled(field, 9, 7, 5);
    EXPECT_EQ(finer.forces.size(), 9u * 7 * 5);
    EXPECT_LT(length_of(finer.forces.back() - field.forces.back()), 1e-12);
    EXPECT_EQ(finer.pitch, 1.0);
}

TEST(InformationGrid, ComponentsOfForcesAreGrids) {
    const Point3 stream[] = {{-1, 0, 0}, {0, 0, 0}, {0.99, 5, 0}};
    EXPECT_EQ(component_of(stream, 0, 1, 5, "a").values, (Cells{0, 2, 4}));
    EXPECT_EQ(component_of(stream, 1, 1, 5, "a").values, (Cells{2, 2, 4}));
    EXPECT_EQ(component_of(stream, 1, 1, 5, "a").rows, 1);
}

}  // namespace
}  // namespace tactics::tests::grid_test
