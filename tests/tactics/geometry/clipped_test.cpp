// SPDX-License-Identifier: Apache-2.0
// Lines and rings cut at a rectangle, beside asking it of many places.
#include "tactics/geometry/clipped.h"

#include <gtest/gtest.h>

#include "tactics/geometry/course.h"
#include "tactics/geometry/walk.h"
#include "tests/filters/pictures.h"

namespace tactics::clipped_test {
namespace {

constexpr Rect kRect{20, 30, 50, 40};

std::vector<Point> some_points(std::uint64_t seed) {
    pictures::Chance chance(seed);
    std::vector<Point> points;
    for (int i = 0; i < 8; ++i) points.push_back({100 * chance.unit(), 100 * chance.unit()});
    return points;
}

double length_of_all(const std::vector<std::vector<Point>>& parts) {
    double length = 0;
    for (const auto& part : parts) length += length_of(Stroke{part});
    return length;
}

TEST(Clipped, AsLongAsWhatOfTheLineIsWithin) {
    for (const bool closed : {false, true})
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const std::vector<Point> points = some_points(seed);
            const double length = length_of(Stroke{points, closed});
            constexpr double kStep = 0.01;
            double within = 0;
            Walk walk(points, closed);
            for (double along = kStep / 2; along < length; along += kStep) within += kRect.holds(walk.to(along)) ? kStep : 0;
            const auto parts = clipped(points, closed, kRect);
            EXPECT_NEAR(length_of_all(parts), within, 0.01 * static_cast<double>(2 * points.size())) << seed;
            for (const auto& part : parts) {
                EXPECT_GE(part.size(), 2u);
                for (const Point& p : part)
                    EXPECT_NEAR(distance(p, {std::clamp(p.x, 20.0, 70.0), std::clamp(p.y, 30.0, 70.0)}), 0, 1e-9);
            }
        }
}

TEST(Clipped, WhatIsWithinStaysAsItIs) {
    const std::vector<Point> line = {{20.1, 30.7}, {33.3, 41.9}, {69.9, 30}};
    const auto parts = clipped(line, false, kRect);
    ASSERT_EQ(parts.size(), 1u);
    for (std::size_t i = 0; i < line.size(); ++i) {
        EXPECT_EQ(parts[0][i].x, line[i].x);
        EXPECT_EQ(parts[0][i].y, line[i].y);
    }
    EXPECT_TRUE(clipped({}, false, kRect).empty());
    EXPECT_TRUE(clipped({{0, 0}, {10, 90}}, false, kRect).empty());
}

TEST(Clipped, ARingHoldsWhatItHeldWithin) {
    const auto holds = [](const std::vector<Point>& ring, Point p) {
        bool inside = false;
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (ray_meets(p, ring[i], ring[(i + 1) % ring.size()])) inside = !inside;
        return inside;
    };
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const std::vector<Point> ring = some_points(seed), cut = ring_within(ring, kRect);
        pictures::Chance chance(seed + 100);
        for (int i = 0; i < 500; ++i) {
            const Point p{100 * chance.unit(), 100 * chance.unit()};
            EXPECT_EQ(holds(cut, p), holds(ring, p) && kRect.holds(p)) << seed;
        }
    }
}

}  // namespace
}  // namespace tactics::clipped_test
