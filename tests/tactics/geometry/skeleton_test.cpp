// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/skeleton.h"

#include <gtest/gtest.h>

#include "tests/filters/shapes.h"

namespace tactics::skeleton_test {
namespace {

// Pieces of pixels of one kind by flood filling, the naive way; the frame counts as ground.
int pieces_of(const InkMap& map, bool ink, bool diagonal) {
    const int w = map.width + 2, h = map.height + 2;
    std::vector<bool> seen(static_cast<std::size_t>(w * h), false);
    int count = 0;
    std::vector<int> open;
    for (int start = 0; start < w * h; ++start) {
        if (seen[static_cast<std::size_t>(start)] || map.ink(start % w - 1, start / w - 1) != ink) continue;
        ++count;
        open.push_back(start);
        seen[static_cast<std::size_t>(start)] = true;
        while (!open.empty()) {
            const int at = open.back();
            open.pop_back();
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    if (!diagonal && dx != 0 && dy != 0) continue;
                    const int x = at % w + dx, y = at / w + dy;
                    if (x < 0 || y < 0 || x >= w || y >= h || map.ink(x - 1, y - 1) != ink) continue;
                    if (seen[static_cast<std::size_t>(y * w + x)]) continue;
                    seen[static_cast<std::size_t>(y * w + x)] = true;
                    open.push_back(y * w + x);
                }
        }
    }
    return count;
}

void expect_same_shape(const Image& image) {
    const InkMap before = ink_of(image);
    const Skeleton after = thin(before);
    EXPECT_EQ(pieces_of(after.map, true, true), pieces_of(before, true, true));
    EXPECT_EQ(pieces_of(after.map, false, false), pieces_of(before, false, false));
    for (const std::uint32_t pixel : after.pixels) EXPECT_TRUE(before.ink(after.x_of(pixel), after.y_of(pixel)));
}

TEST(Skeleton, KeepsThePiecesAndHolesOfRandomPictures) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        expect_same_shape(shapes::random_picture(40 + static_cast<int>(seed % 7), 30, seed, 5 + seed % 12 * 7));
    }
}

TEST(Skeleton, TakesPicturesOfAnySize) {
    for (const auto& [w, h] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 3}, {40, 17}}) {
        Image image = shapes::blank(w, h);
        expect_same_shape(image);
        for (auto& pixel : image.pixels) pixel = 0;
        expect_same_shape(image);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = (i % static_cast<std::size_t>(w) + i / static_cast<std::size_t>(w)) % 2 == 0 ? 0 : 255;
        expect_same_shape(image);
    }
}

// No pixel of what is left could go without breaking a line or shortening it, but in knots of junctions.
TEST(Skeleton, IsOnePixelWide) {
    for (int degrees = 0; degrees < 180; degrees += 7) {
        Image image = shapes::blank(120, 120);
        const double a = degrees * 3.14159265 / 180;
        shapes::bar(image, {60 - 45 * std::cos(a), 60 - 45 * std::sin(a)}, {60 + 45 * std::cos(a), 60 + 45 * std::sin(a)}, 7);
        const Skeleton skeleton = thin(ink_of(image));
        const double steps = 90 * std::max(std::abs(std::cos(a)), std::abs(std::sin(a)));
        EXPECT_NEAR(static_cast<double>(skeleton.pixels.size()), steps, 12) << degrees;
    }
}

TEST(Skeleton, TellsHowWideTheInkWas) {
    for (const int width : {1, 3, 7, 15}) {
        Image image = shapes::blank(100, 40);
        for (int y = 0; y < width; ++y)
            for (int x = 5; x < 95; ++x) image.row(10 + y)[x] = 0;
        const Skeleton skeleton = thin(ink_of(image));
        for (const std::uint32_t pixel : skeleton.pixels) {
            if (std::abs(skeleton.x_of(pixel) - 50) < 20) {
                EXPECT_NEAR(skeleton.half_width(pixel), width / 2.0, 0.51);
            }
        }
    }
}

}  // namespace
}  // namespace tactics::skeleton_test
