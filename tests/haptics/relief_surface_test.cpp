// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/relief_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/haptics/reliefs.h"

namespace tactics::relief_surface_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();

TEST(ReliefSurface, IsExactOnAPlane) {
    const auto plane = [](double x, double y) { return 1 + 0.25 * x - 0.5 * y; };
    const ReliefSurface surface(map_of(20, 10, 0.5, plane));  // the samples are exact as float
    RandomNumbers random(1);
    for (int i = 0; i < 1000; ++i) {
        const Point at{0.25 + 9.5 * random.uniform(), 0.25 + 4.5 * random.uniform()};
        EXPECT_NEAR(surface.height(at), plane(at.x, at.y), 1e-12);
        EXPECT_NEAR(surface.slope(at).x, 0.25, 1e-12);
        EXPECT_NEAR(surface.slope(at).y, -0.5, 1e-12);
    }
}

TEST(ReliefSurface, GoesThroughItsSamplesAndHasNoStepAtTheBordersOfSquares) {
    for (const HardRelief& relief : hard_reliefs()) {
        const ReliefSurface surface(relief.map);
        const HeightMap& map = surface.map();
        const double steepest = (surface.highest() - surface.lowest()) / map.pitch;
        constexpr double kNear = 1e-9;
        for (int row = 0; row < map.rows; ++row)
            for (int column = 0; column < map.columns; ++column) {
                const Point at{(column + 0.5) * map.pitch, (row + 0.5) * map.pitch};
                ASSERT_NEAR(surface.height(at), static_cast<double>(map.at(column, row)), 1e-12 + 1e-12 * steepest)
                    << relief.name;
                const Point between{at.x, at.y + 0.3 * map.pitch};
                ASSERT_NEAR(surface.height({between.x - kNear, between.y}), surface.height({between.x + kNear, between.y}),
                            2.1 * kNear * steepest + 1e-12)
                    << relief.name;
                ASSERT_NEAR(surface.height({between.y, between.x - kNear}), surface.height({between.y, between.x + kNear}),
                            2.1 * kNear * steepest + 1e-12)
                    << relief.name;
            }
    }
}

TEST(ReliefSurface, ItsSlopeIsItsDerivative) {
    RandomNumbers random(2);
    for (const HardRelief& relief : hard_reliefs()) {
        const ReliefSurface surface(relief.map);
        const double pitch = relief.map.pitch, width = relief.map.width(), height = relief.map.height();
        for (int i = 0; i < 300; ++i) {
            const double step = pitch * 1e-4;
            // Within a square, or beside the map.
            const Point at{
                (std::floor((width * (1.4 * random.uniform() - 0.2)) / pitch) + 0.51 + 0.98 * random.uniform()) * pitch,
                (std::floor((height * (1.4 * random.uniform() - 0.2)) / pitch) + 0.51 + 0.98 * random.uniform()) * pitch};
            const double across = (surface.height({at.x + step, at.y}) - surface.height({at.x - step, at.y})) / (2 * step);
            const double down = (surface.height({at.x, at.y + step}) - surface.height({at.x, at.y - step})) / (2 * step);
            EXPECT_NEAR(surface.slope(at).x, across, 1e-8) << relief.name;
            EXPECT_NEAR(surface.slope(at).y, down, 1e-8) << relief.name;
        }
    }
}

TEST(ReliefSurface, IsBesideTheMapAsAtItsEdgeAndLowestNowhere) {
    const ReliefSurface surface(map_of(40, 30, 0.5, terrain));
    EXPECT_EQ(surface.height({-7, 6}), surface.height({0.25, 6}));
    EXPECT_EQ(surface.height({1e300, -kEndless}), static_cast<double>(surface.map().at(39, 0)));
    EXPECT_EQ(surface.height({3, kEndless}), surface.height({3, 14.75}));
    EXPECT_EQ(surface.slope({-7, 6}).x, 0);
    EXPECT_EQ(surface.slope({-7, 6}).y, surface.slope({0.25, 6}).y);
    EXPECT_EQ(surface.height({kNan, 3}), surface.lowest());
    EXPECT_EQ(surface.height({3, kNan}), surface.lowest());
    EXPECT_EQ(surface.slope({kNan, 3}).y, 0);
    const auto [lowest, highest] = std::minmax_element(surface.map().heights.begin(), surface.map().heights.end());
    EXPECT_EQ(surface.lowest(), static_cast<double>(*lowest));
    EXPECT_EQ(surface.highest(), static_cast<double>(*highest));
}

TEST(ReliefSurface, FillsHolesFromWhatIsAroundThem) {
    constexpr float kHole = std::numeric_limits<float>::quiet_NaN();
    HeightMap map = map_of(9, 7, 1, [](double x, double) { return x; });
    for (int row = 2; row < 5; ++row)
        for (int column = 3; column < 6; ++column)
            map.at(column, row) = row == 3 ? -std::numeric_limits<float>::infinity() : kHole;
    const ReliefSurface surface(map);
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 9; ++column) {
            const bool hole = column > 2 && column < 6 && row > 1 && row < 5;
            const float filled = surface.map().at(column, row);
            if (hole) {
                EXPECT_GE(filled, 2.5F);  // between the heights beside the hole
                EXPECT_LE(filled, 6.5F);
            } else {
                EXPECT_EQ(filled, map.at(column, row));
            }
        }
    EXPECT_EQ(surface.map().at(4, 3), 4.5F);  // as far from both sides
    const ReliefSurface none(map_of(3, 3, 1, [](double, double) { return kHole; }));
    EXPECT_EQ(none.height({1, 1}), 0);
    EXPECT_EQ(none.highest(), 0);
}

TEST(ReliefSurface, OfNothingIsRefused) {
    EXPECT_THROW(ReliefSurface(HeightMap{}), std::logic_error);
    EXPECT_THROW(ReliefSurface(HeightMap{1, 1, 0, {0}}), std::logic_error);
    EXPECT_THROW(ReliefSurface(HeightMap{1, 1, kNan, {0}}), std::logic_error);
    EXPECT_THROW(ReliefSurface(HeightMap{2, 1, 1, {0}}), std::logic_error);
    EXPECT_THROW(dilated(HeightMap{2, 1, 1, {0}}, 1), std::logic_error);
}

// What its definition says, sample by sample.
HeightMap dilated_twin(const HeightMap& map, double radius) {
    HeightMap made = map;
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.columns; ++x)
            for (int j = 0; j < map.rows; ++j)
                for (int i = 0; i < map.columns; ++i) {
                    const double far = std::hypot(i - x, j - y) * map.pitch;
                    if (far > radius) continue;
                    const auto sunk = static_cast<float>(std::sqrt(radius * radius - far * far) - radius);
                    made.at(x, y) = std::max(made.at(x, y), map.at(i, j) + sunk);
                }
    return made;
}

TEST(Dilated, IsWhatItsDefinitionSays) {
    for (const HardRelief& relief : hard_reliefs()) {
        if (relief.map.heights.size() > 2000) continue;
        const HeightMap filled = ReliefSurface(relief.map).map();
        for (const double radius : {0.3, 1.1, 2.0, 7.3}) {
            const HeightMap ours = dilated(relief.map, radius), twin = dilated_twin(filled, radius);
            ASSERT_EQ(ours.heights.size(), twin.heights.size());
            for (std::size_t i = 0; i < twin.heights.size(); ++i) {
                ASSERT_NEAR(ours.heights[i], twin.heights[i], 1e-5)
                    << relief.name << " " << radius;  // the same roots, rounded twice
                ASSERT_GE(ours.heights[i], filled.heights[i]) << relief.name << " " << radius;
            }
        }
    }
}

TEST(Dilated, IsExactOnLevelGroundAtASpikeAndAtAStep) {
    constexpr double kRadius = 2, kPitch = 0.25;
    const HeightMap level = dilated(map_of(30, 20, kPitch, [](double, double) { return 3; }), kRadius);
    EXPECT_TRUE(std::all_of(level.heights.begin(), level.heights.end(), [](float h) { return h == 3; }));
    HeightMap spike = map_of(41, 41, kPitch, [](double, double) { return 0; });
    spike.at(20, 20) = 10;
    const HeightMap ball = dilated(spike, kRadius);
    const HeightMap edge = dilated(map_of(40, 5, kPitch, [](double x, double) { return x < 5 ? 0 : 10; }), kRadius);
    const auto beside = [](double top, double far) {
        return far > kRadius ? 0 : top - kRadius + std::sqrt(kRadius * kRadius - far * far);
    };
    for (int i = 0; i < 41; ++i) EXPECT_NEAR(ball.at(i, 20), beside(10, std::abs(i - 20) * kPitch), 1e-6) << i;
    EXPECT_NEAR(ball.at(23, 24), beside(10, 5 * kPitch), 1e-6);
    for (int i = 0; i < 20; ++i) EXPECT_NEAR(edge.at(i, 2), beside(10, (20 - i) * kPitch), 1e-6) << i;
    for (int i = 20; i < 40; ++i) EXPECT_EQ(edge.at(i, 2), 10.0F);
}

// A ball on a slope s stands radius (sqrt(1 + s^2) - 1) above it, measured upwards.
TEST(Dilated, OnASlopeIsTheBallOnIt) {
    constexpr double kRadius = 2, kSlope = 0.75;
    for (const double pitch : {0.2, 0.1, 0.05}) {
        const auto plane = [](double x, double) { return kSlope * x; };
        const int columns = static_cast<int>(8 / pitch);
        const HeightMap made = dilated(map_of(columns, columns, pitch, plane), kRadius);
        const double raised = kRadius * (std::sqrt(1 + kSlope * kSlope) - 1),
                     most = pitch * pitch / (4 * kRadius) * std::pow(1 + kSlope * kSlope, 1.5);
        const double short_by =
            kSlope * (columns / 2 + 0.5) * pitch + raised - static_cast<double>(made.at(columns / 2, columns / 2));
        EXPECT_GE(short_by, -1e-5);
        EXPECT_LE(short_by, most);
    }
}

TEST(Dilated, WithoutARadiusIsTheMapItself) {
    for (const HardRelief& relief : hard_reliefs()) {
        const HeightMap same = dilated(relief.map, 0);
        for (std::size_t i = 0; i < same.heights.size(); ++i)
            EXPECT_TRUE(same.heights[i] == relief.map.heights[i] ||
                        (std::isnan(same.heights[i]) && std::isnan(relief.map.heights[i])));
    }
}

}  // namespace
}  // namespace tactics::relief_surface_test
