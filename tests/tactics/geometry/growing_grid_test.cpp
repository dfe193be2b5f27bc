// SPDX-License-Identifier: Apache-2.0
// Boxes in cells, beside looking at all of them.
#include "tactics/geometry/growing_grid.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/filters/pictures.h"

namespace tactics::growing_grid_test {
namespace {

std::vector<std::size_t> near(const GrowingGrid& grid, const Box& box) {
    std::vector<std::size_t> found;
    grid.any_near(box, [&](std::size_t number) {
        found.push_back(number);
        return false;
    });
    std::sort(found.begin(), found.end());
    return found;
}

TEST(GrowingGrid, FindsEachBoxThatLookingAtAllFindsOnce) {
    for (const Box& area : {Box{0, 50, 100, 130}, Box{0, 0, 0, 0}, Box{-1e5, 0, 1e5, 1}, kNothing})
        for (const double size : {0.0, 3.0, 90.0}) {
            pictures::Chance chance(1);
            const auto box = [&] {
                const Point at{140 * chance.unit() - 20, 50 + 120 * chance.unit() - 20};
                return Box{at.x, at.y, at.x + size * chance.unit(), at.y + size * chance.unit()};
            };
            GrowingGrid grid(area, 300);
            std::vector<Box> all;
            for (std::size_t i = 0; i < 300; ++i) {
                all.push_back(box());
                grid.add(all.back());
                const Box at = box();
                std::vector<std::size_t> twin;
                for (std::size_t k = 0; k < all.size(); ++k)
                    if (meet(all[k], at)) twin.push_back(k);
                ASSERT_EQ(near(grid, at), twin) << size << " " << i;
            }
        }
}

TEST(GrowingGrid, BearsWhatIsNowhere) {
    GrowingGrid grid({0, 0, 10, 10}, 3);
    grid.add(kNothing);
    grid.add({-1e300, -1e300, 1e300, 1e300});
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    grid.add({kNone, kNone, kNone, kNone});
    EXPECT_EQ(near(grid, {5, 5, 6, 6}), (std::vector<std::size_t>{1}));
    EXPECT_TRUE(near(grid, kNothing).empty());
}

}  // namespace
}  // namespace tactics::growing_grid_test
