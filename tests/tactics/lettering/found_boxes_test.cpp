// SPDX-License-Identifier: Apache-2.0
// Boxes found again, beside looking at all of them.
#include "tactics/lettering/found_boxes.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

namespace tactics::found_boxes_test {
namespace {

TEST(FoundBoxes, AreThoseThatOverlap) {
    std::mt19937 random(5);
    const auto some = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    for (const auto& size : {std::pair(1, 1), {64, 64}, {65, 500}, {1000, 130}}) {
        const int width = size.first, height = size.second;  // a structured binding could not be captured
        const auto box = [&] {
            const int left = some(width), top = some(height);
            return PixelBox{left, top, left + 1 + some(width - left), top + 1 + some(height - top)};
        };
        FoundBoxes boxes(width, height);
        std::vector<PixelBox> all;
        for (int i = 0; i < 50; ++i) {
            all.push_back(box());
            boxes.add(all.back());
        }
        for (int i = 0; i < 100; ++i) {
            const PixelBox wanted = box();
            std::set<std::size_t> found, expected;
            EXPECT_FALSE(boxes.any_on(wanted, [&](std::size_t number, const PixelBox&) {
                found.insert(number);
                return false;
            }));
            for (std::size_t k = 0; k < all.size(); ++k)
                if (wanted.left < all[k].right && all[k].left < wanted.right && wanted.top < all[k].bottom &&
                    all[k].top < wanted.bottom)
                    expected.insert(k);
            EXPECT_EQ(found, expected);
            EXPECT_EQ(boxes.any_on(wanted, [](std::size_t, const PixelBox&) { return true; }), !expected.empty());
        }
    }
}

}  // namespace
}  // namespace tactics::found_boxes_test
