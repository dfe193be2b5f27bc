// SPDX-License-Identifier: Apache-2.0
// Boxes in cells, beside looking at all of them.
#include "tactics/geometry/grid.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/filters/pictures.h"

namespace tactics::grid_test {
namespace {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

// On a page of 200 x 300 mm, and as far beside it as told.
std::vector<Box> some_boxes(std::uint64_t seed, double beside) {
    pictures::Chance chance(seed);
    std::vector<Box> boxes;
    for (int i = 0; i < 300; ++i) {
        const double x = (200 + 2 * beside) * chance.unit() - beside, y = (300 + 2 * beside) * chance.unit() - beside,
                     side = 40 * chance.unit();
        boxes.push_back({x, y, x + side, y + side * chance.unit()});
    }
    return boxes;
}

TEST(Grid, FindsThePairsThatMeetOnceAndTheBoxesThatAreNear) {
    for (const double beside : {0.0, 30.0, 3000.0})
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            const std::vector<Box> boxes = some_boxes(seed, beside);
            const Grid grid(boxes, 200, 300);
            Pairs all, found;
            for (std::size_t i = 0; i < boxes.size(); ++i)
                for (std::size_t j = i + 1; j < boxes.size(); ++j)
                    if (meet(boxes[i], boxes[j])) all.insert({i, j});
            EXPECT_TRUE(grid.pairs(1'000'000, [&](std::size_t i, std::size_t j) {
                EXPECT_TRUE(found.insert(std::minmax(i, j)).second) << i << " " << j;
                return true;
            }));
            EXPECT_EQ(found, all) << beside;
            for (const Box& box : some_boxes(seed + 10, beside)) {
                std::set<std::size_t> near, twin;
                grid.any_near(box, [&](std::size_t i) {
                    near.insert(i);
                    return false;
                });
                for (std::size_t i = 0; i < boxes.size(); ++i)
                    if (meet(boxes[i], box)) twin.insert(i);
                EXPECT_EQ(near, twin);
            }
        }
}

// A line of 80 m in pieces, of which 79.8 m are beside the page, is not one heap.
TEST(Grid, WhatIsFarBesideThePageIsNotLookedAtPieceByPiece) {
    std::vector<Box> boxes;
    for (int i = 0; i < 40'000; ++i) boxes.push_back({2.0 * i, 10, 2.0 * i + 2, 11});
    std::size_t met = 0;
    EXPECT_TRUE(Grid(boxes, 200, 300).pairs(20'000'000, [&](std::size_t, std::size_t) { return ++met > 0; }));
    EXPECT_EQ(met, boxes.size() - 1);
}

}  // namespace
}  // namespace tactics::grid_test
