// SPDX-License-Identifier: Apache-2.0
// Gaps against GEOS, the geometry library: the distances of 1,000 random pages. Only where libgeos is installed.
#include <gtest/gtest.h>

#include "tests/rules/pages.h"

#if TACTICS_HAS_GEOS

#include <geos_c.h>

#include <cstdarg>
#include <memory>

namespace tactics {
namespace {

using namespace tests;

struct Geos {
    GEOSContextHandle_t handle = GEOS_init_r();
    ~Geos() { GEOS_finish_r(handle); }
};

class Shape {
public:
    Shape(const Geos& geos, const std::vector<std::vector<Point>>& rings, bool area) : geos_(geos) {
        std::vector<GEOSGeometry*> parts;
        for (const auto& ring : rings) {
            const std::size_t count = ring.size() + (area ? 1 : 0);
            GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geos.handle, static_cast<unsigned>(count), 2);
            for (unsigned i = 0; i < count; ++i)
                GEOSCoordSeq_setXY_r(geos.handle, sequence, i, ring[i % ring.size()].x, ring[i % ring.size()].y);
            parts.push_back(area ? GEOSGeom_createLinearRing_r(geos.handle, sequence)
                                 : GEOSGeom_createLineString_r(geos.handle, sequence));
        }
        shape_ = area ? GEOSGeom_createPolygon_r(geos.handle, parts[0], parts.data() + 1, static_cast<unsigned>(parts.size() - 1))
                      : parts[0];
    }
    ~Shape() { GEOSGeom_destroy_r(geos_.handle, shape_); }
    Shape(const Shape&) = delete;
    Shape& operator=(const Shape&) = delete;
    double distance_to(const Shape& other) const {
        double apart = -1;
        GEOSDistance_r(geos_.handle, shape_, other.shape_, &apart);
        return apart;
    }

private:
    const Geos& geos_;
    GEOSGeometry* shape_ = nullptr;
};

// Two things on each page, lines and areas with and without holes, near each other: what is told is what GEOS measures.
TEST(Geos, MeasuresTheSameGapsOnAThousandPages) {
    const Geos geos;
    Chance chance(2);
    int told = 0, touching = 0, far = 0;
    for (int round = 0; round < 1000; ++round) {
        Page page = blank_page(100, 100);
        std::vector<std::unique_ptr<Shape>> shapes;
        double ink = 0;
        for (int i = 0; i < 2; ++i) {
            const Point at{chance.between(25, 75), chance.between(25, 75)};
            if (chance.below(2) == 0) {
                const double width = chance.between(0.3, 3);
                const auto line = wandering_line(chance, at, 2 + chance.below(6), 9);
                add_line(page, line, width);
                shapes.push_back(std::make_unique<Shape>(geos, std::vector<std::vector<Point>>{line}, false));
                ink += width / 2;
            } else {
                std::vector<std::vector<Point>> rings{starry_ring(chance, at, 9, 15)};
                if (chance.below(2) == 0) rings.push_back(starry_ring(chance, at, 1, 4));
                page.areas.push_back({rings});
                shapes.push_back(std::make_unique<Shape>(geos, rings, true));
            }
        }
        const double gap = shapes[0]->distance_to(*shapes[1]) - ink;
        constexpr double kLimit = 6;
        std::vector<Finding> between;
        for (const Finding& finding : findings_of(page, "gap", kLimit).places)
            if (finding.message.find("parts of") == std::string::npos) between.push_back(finding);
        if (gap > 0.03 && gap < kLimit - 0.01) {
            // A line in the hole of an area is near to all sides of it, so there may be more than one place.
            ASSERT_FALSE(between.empty()) << "round " << round << ", GEOS says " << gap;
            double least = 1e9;
            for (const Finding& finding : between) least = std::min(least, finding.measured);
            EXPECT_NEAR(least, gap, 0.01) << round;
            ++told;
        } else if (gap > kLimit) {
            EXPECT_TRUE(between.empty()) << round << " " << between[0].message << " at " << between[0].at.x << " "
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
}  // namespace tactics

#else

namespace tactics {
namespace {

TEST(Geos, MeasuresTheSameGapsOnAThousandPages) { GTEST_SKIP() << "libgeos is not installed"; }

}  // namespace
}  // namespace tactics

#endif
