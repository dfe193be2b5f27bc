// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/four_boxes.h"

#include <gtest/gtest.h>

#include <vector>

#include "tactics/haptics/scenes/mesh_tree.h"
#include "tests/haptics/meshes.h"

namespace tactics::four_boxes_test {
namespace {

using namespace tests;

double twin_distance(const FacetCorners& f, const Point3& place) {
    const Exact3 p(place), off = p - nearest_by_sides(p, {Exact3(f.a), Exact3(f.b), Exact3(f.c)});
    return static_cast<double>(std::sqrt(dot(off, off)));
}

struct Anything {
    RandomNumbers random;
    double in(double low, double high) { return low + (high - low) * random.uniform(); }
    Point3 within(double wide) { return {in(-wide, wide), in(-wide, wide), in(-wide, wide)}; }
    // Of every size, some very narrow, far from 0 or near.
    FacetCorners facet(const Point3& about) {
        const double size = std::pow(10, in(-1.5, 1.5));
        FacetCorners f{about + within(size), about + within(size), about + within(size)};
        if (random.uniform() < 0.2) f.c = f.a + random.uniform() * (f.b - f.a) + within(1e-4 * size);
        return f;
    }
    std::vector<FacetCorners> facets(const Point3& about) {
        std::vector<FacetCorners> made;
        for (double count = in(1, 4.99); count >= 1; --count) made.push_back(facet(about));
        return made;
    }
};

TEST(FourFacets, AreNeverNearerThanTheySayAndSeldomMuchFarther) {
    Anything any{RandomNumbers(1)};
    double told = 0, is = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Point3 about = any.within(i % 2 == 0 ? 100 : 1);
        const std::vector<FacetCorners> facets = any.facets(about);
        const FourFacets four(facets.data(), 0, static_cast<std::uint32_t>(facets.size()));
        const Point3 place = about + any.within(std::pow(10, any.in(-3, 2)));
        const Four bound = four.squared_at_least(place);
        for (std::size_t lane = 0; lane < 4; ++lane) {
            if (lane >= facets.size()) {
                ASSERT_GT(bound[lane], 1e30f);
                continue;
            }
            const double far = twin_distance(facets[lane], place), least = std::sqrt(double{bound[lane]});
            ASSERT_LE(least, far) << i;
            told += least / std::max(far, 1e-9);
            is += 1;
        }
    }
    EXPECT_GT(told / is, 0.9);
}

TEST(FourFacets, MissNothingThatABallComesTo) {
    Anything any{RandomNumbers(2)};
    int wanted = 0, met = 0, all = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Point3 about = any.within(50);
        const std::vector<FacetCorners> facets = any.facets(about);
        const FourFacets four(facets.data(), 0, static_cast<std::uint32_t>(facets.size()));
        const Point3 ball = about + any.within(10), way = about + any.within(10) - ball;
        const double radius = i % 3 == 0 ? 1e-5 : any.in(0, 2);
        const unsigned may = four.may_meet(ball, way, radius);
        for (std::size_t lane = 0; lane < facets.size(); ++lane, ++all) {
            bool near = false;
            for (int k = 0; k <= 60 && !near; ++k) near = twin_distance(facets[lane], ball + k / 60.0 * way) <= radius;
            const bool meets = meeting(facets[lane], ball, way, length_of(way), radius, 1) <= 1;
            wanted += (may >> lane & 1) != 0 ? 1 : 0;
            met += near || meets ? 1 : 0;
            ASSERT_TRUE((may >> lane & 1) != 0 || !(near || meets)) << i << " " << near << meets;
        }
        ASSERT_EQ(may >> facets.size(), 0u);
    }
    EXPECT_GT(met, 1'000);
    EXPECT_LT(wanted, 3 * met);
    EXPECT_LT(wanted, all / 2);
}

TEST(Meeting, IsWhereTheBallTouchesAndNotBefore) {
    Anything any{RandomNumbers(3)};
    int met = 0;
    for (int i = 0; i < 50'000; ++i) {
        const FacetCorners facet = any.facet({});
        if (twin_distance({facet.b, facet.c, facet.c}, facet.a) < 1e-3) continue;
        const Point3 ball = any.within(10), way = any.within(10) - ball;
        const double radius = i % 3 == 0 ? 1e-5 : any.in(0.01, 2);
        if (twin_distance(facet, ball) <= radius) continue;
        const double share = meeting(facet, ball, way, length_of(way), radius, 1);
        for (int k = 0; k < 40; ++k)
            ASSERT_GE(twin_distance(facet, ball + std::min(share, 1.0) * k / 40.0 * way), radius - 1e-9) << i;
        if (share > 1) continue;
        ++met;
        ASSERT_NEAR(twin_distance(facet, ball + share * way), radius, 1e-9) << i;
    }
    EXPECT_GT(met, 2'000);
}

TEST(MeshVicinity, AnswersAsTheWholeTreeDoes) {
    for (const bool closed : {false, true}) {
        const MeshTree tree(facets_of(closed ? star_mesh(3, 4) : soup_mesh(200, 5)));
        Anything any{RandomNumbers(4)};
        int known = 0;
        MeshVicinity vicinity;
        for (int i = 0; i < 5'000; ++i) {
            const Point3 middle = any.within(10);
            const double reach = any.in(0.1, 4), radius = any.in(0, reach / 2);
            int work = 1'000'000;
            if (!tree.look_around(middle, reach, vicinity, work)) {
                EXPECT_LT(vicinity.reach, 0);
                continue;
            }
            ++known;
            const double free = (reach - radius) / 2;
            const Point3 ball = middle + any.within(free / 2), way = middle + any.within(free / 2) - ball;
            const MeshTree::Near near = tree.nearest(ball, radius, {}, work),
                                 same = tree.nearest(ball, radius, {}, vicinity, work);
            ASSERT_EQ(near.distance, same.distance);
            const MeshTree::Hit hit = tree.first_met(ball, way, radius, {}, work);
            const MeshTree::Hit like = tree.first_met(ball, way, radius, {}, 1, vicinity, work);
            ASSERT_EQ(hit.share, like.share);
            ASSERT_GT(work, 0);
        }
        EXPECT_GT(known, 1'000);
    }
}

}  // namespace
}  // namespace tactics::four_boxes_test
