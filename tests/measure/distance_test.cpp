// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/distance.h"

#include <gtest/gtest.h>

#include <random>

namespace tactics::distance_test {
namespace {

TEST(Distance, AgreesWithLookingAtEveryPixel) {
    std::mt19937 random(11);
    for (int i = 0; i < 80; ++i) {
        PixelSet set{1 + static_cast<int>(random() % 23), 1 + static_cast<int>(random() % 17), {}};
        const int rarity = 1 + static_cast<int>(random() % 60);
        for (int pixel = 0; pixel < set.width * set.height; ++pixel)
            if (random() % static_cast<unsigned>(rarity) == 0) set.pixels.push_back(static_cast<std::uint32_t>(pixel));
        const auto squares = squared_distances(set);
        ASSERT_EQ(squares.size(), static_cast<std::size_t>(set.width * set.height));
        for (int pixel = 0; pixel < set.width * set.height; ++pixel) {
            std::int64_t nearest = kNoDistance;
            for (const std::uint32_t other : set.pixels) {
                const std::int64_t dx = pixel % set.width - static_cast<int>(other) % set.width,
                                   dy = pixel / set.width - static_cast<int>(other) / set.width;
                nearest = std::min(nearest, dx * dx + dy * dy);
            }
            ASSERT_EQ(squares[static_cast<std::size_t>(pixel)], nearest) << i << " at " << pixel;
        }
    }
}

}  // namespace
}  // namespace tactics::distance_test
