// SPDX-License-Identifier: Apache-2.0
// Points in cells, beside looking at all of them.
#include "tactics/geometry/places.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/filters/pictures.h"

namespace tactics::places_test {
namespace {

std::set<std::size_t> near(const Places& places, Point at, double reach) {
    std::set<std::size_t> found;
    places.any_near(at, reach, [&](std::size_t i) {
        if (distance(places[i], at) < reach) found.insert(i);
        return false;
    });
    return found;
}

TEST(Places, FindsThePointsThatLookingAtAllFinds) {
    for (const double beside : {0.0, 40.0})
        for (const double reach : {0.3, 3.0, 25.0}) {
            pictures::Chance chance(1);
            const auto point = [&] {
                return Point{(100 + 2 * beside) * chance.unit() - beside, 50 + (80 + 2 * beside) * chance.unit() - beside};
            };
            Places places({0, 50, 100, 130}, 3);
            std::vector<Point> all;
            for (int i = 0; i < 500; ++i) {
                if (i % 50 == 49) {
                    all.resize(all.size() - 20);
                    places.shrink(all.size());
                }
                all.push_back(point());
                places.add(all.back());
                const Point at = point();
                std::set<std::size_t> twin;
                for (std::size_t k = 0; k < all.size(); ++k)
                    if (distance(all[k], at) < reach) twin.insert(k);
                ASSERT_EQ(near(places, at, reach), twin) << beside << " " << reach << " " << i;
            }
        }
}

TEST(Places, AreAnywhereEvenWithoutAnArea) {
    Places places(kNothing, 2);
    places.add({-1e9, 1e300});
    places.add({5, 5});
    EXPECT_EQ(near(places, {5.5, 5}, 1), (std::set<std::size_t>{1}));
    EXPECT_FALSE(Places(Box{}, 1).any_near({0, 0}, 10, [](std::size_t) { return true; }));
}

TEST(Places, GiveUpWhenOneWillDo) {
    Places places({0, 0, 10, 10}, 1);
    for (int i = 0; i < 10; ++i) places.add({5, 5});
    int seen = 0;
    EXPECT_TRUE(places.any_near({5, 5}, 1, [&](std::size_t i) {
        EXPECT_EQ(i, 9u);  // the newest
        return ++seen == 1;
    }));
    EXPECT_EQ(seen, 1);
}

}  // namespace
}  // namespace tactics::places_test
