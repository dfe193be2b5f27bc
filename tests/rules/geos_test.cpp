// SPDX-License-Identifier: Apache-2.0
// Gaps against GEOS, the geometry library: the distances of 1,000 random pages. Only where libgeos is installed.
#include <gtest/gtest.h>

#include "tests/rules/pages.h"

#if TACTICS_HAS_GEOS

#include "tests/geos_shape.h"

namespace tactics::geos_test {
namespace {

using namespace tests;

// Two things on each page, lines and areas with and without holes, near each other: what is told is what GEOS measures.
TEST(Geos, MeasuresTheSameGapsOnAThousandPages) {
    const Geos geos;
    Dice chance(2);
    int told = 0, touching = 0, far = 0;
    for (int round = 0; round < 1000; ++round) {
        Page page = blank_page(100, 100);
        std::vector<GeosShape> shapes;
        double ink = 0;
        for (int i = 0; i < 2; ++i) {
            const Point at{chance.between(25, 75), chance.between(25, 75)};
            if (chance.below(2) == 0) {
                const double width = chance.between(0.3, 3);
                const auto line = wandering_line(chance, at, 2 + chance.below(6), 9);
                add_line(page, line, width);
                shapes.push_back(GeosShape::line(geos, line));
                ink += width / 2;
            } else {
                std::vector<std::vector<Point>> rings{starry_ring(chance, at, 9, 15)};
                if (chance.below(2) == 0) rings.push_back(starry_ring(chance, at, 1, 4));
                page.areas.push_back({rings});
                shapes.push_back(GeosShape::area(geos, rings));
            }
        }
        const double gap = shapes[0].distance_to(shapes[1]) - ink;
        constexpr double kLimit = 6;
        std::vector<Finding> between;
        for (const Finding& finding : findings_of(page, "gap", kLimit).places)
            if (finding.message.english().find("parts of") == std::string::npos) between.push_back(finding);
        if (gap > 0.03 && gap < kLimit - 0.01) {
            // A line in the hole of an area is near to all sides of it, so there may be more than one place.
            ASSERT_FALSE(between.empty()) << "round " << round << ", GEOS says " << gap;
            double least = 1e9;
            for (const Finding& finding : between) least = std::min(least, finding.measured);
            EXPECT_NEAR(least, gap, 0.01) << round;
            ++told;
        } else if (gap > kLimit) {
            EXPECT_TRUE(between.empty()) << round << " " << between[0].message.english() << " at " << between[0].at.x << " "
                                         << between[0].at.y << ", GEOS says " << gap;
            ++far;
        } else if (gap < 0) {
            ++touching;
        }
    }
    EXPECT_GT(told, 120);
    EXPECT_GT(far, 100);
    EXPECT_GT(touching, 100);
}

}  // namespace
}  // namespace tactics::geos_test

#else

namespace tactics::geos_test {
namespace {

TEST(Geos, MeasuresTheSameGapsOnAThousandPages) { GTEST_SKIP() << "libgeos is not installed"; }

}  // namespace
}  // namespace tactics::geos_test

#endif
