// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/near_borders.h"

#include <gtest/gtest.h>

#include <random>

namespace tactics::near_borders_test {
namespace {

// All borders that looking at each finds, for places near and far, and not many others.
TEST(NearBorders, FindsWhatLookingAtAllFinds) {
    std::mt19937 random(3);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
    };
    for (const double reach : {0.1, 1.0, 8.0}) {
        FlatLayout layout;
        for (int i = 0; i < 120; ++i) {
            const double size = i % 3 == 0 ? 150 : 12, x = between(0, 200), y = between(0, 300);
            std::vector<Point> ring;
            for (int corner = 0; corner < 3 + i % 4; ++corner) ring.push_back({x + between(0, size), y + between(0, size)});
            PlacedPanel placed{.handling = i % 10 == 9 ? Handling::folded : Handling::kept, .placement = {}, .shape = {}};
            placed.shape = flat_shape({ring});
            layout.panels.push_back(std::move(placed));
        }
        const NearBorders near(layout, reach);
        std::size_t missed = 0, found = 0, looked_at = 0;
        for (int i = 0; i < 2000; ++i) {
            const Point at{between(-20, 370), between(-20, 470)};
            std::vector<char> visited(layout.panels.size(), 0);
            EXPECT_FALSE(near.any_near(at, [&](std::size_t panel) {
                visited[panel] = 1;
                return false;
            }));
            for (std::size_t panel = 0; panel < layout.panels.size(); ++panel) {
                const bool is_near = layout.panels[panel].handling == Handling::kept &&
                                     distance_to_border(layout.panels[panel].shape, at) <= reach;
                found += is_near;
                missed += is_near && visited[panel] == 0;
                looked_at += visited[panel];
            }
        }
        EXPECT_EQ(missed, 0u) << reach;
        EXPECT_GT(found, 10u) << reach;
        EXPECT_LT(looked_at, 12 * found + 200) << reach;  // all would be 216,000
    }
}

}  // namespace
}  // namespace tactics::near_borders_test
