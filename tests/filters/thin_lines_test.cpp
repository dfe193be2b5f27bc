// SPDX-License-Identifier: Apache-2.0
// Contours of drawn pictures: thin lines by their middle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/filters/pictures.h"

namespace tactics::thin_lines_test {
namespace {

constexpr double kPixel = 0.17;  // mm: 150 dpi

EdgeMap contours(Image image, const char* step) { return std::get<EdgeMap>(pictures::filtered(step, std::move(image))); }

void fill(Image& image, int left, int top, int right, int bottom, std::uint8_t grey) {
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) image.row(y)[x] = grey;
}

std::size_t edges_in_column(const EdgeMap& map, int x, int top, int bottom) {
    std::size_t count = 0;
    for (int y = top; y < bottom; ++y) count += map.strength[static_cast<std::size_t>(y * map.width + x)] > 0 ? 1 : 0;
    return count;
}

// Axes of 2 pixels (0.3 mm), a pale grid of 2, a bar that stands on the axis.
Image chart(std::uint8_t ground, std::uint8_t ink) {
    Image image = make_image(300, 200, 1, kPixel, ground);
    for (const int y : {40, 90}) fill(image, 20, y, 280, y + 2, static_cast<std::uint8_t>(ground + (ink - ground) * 79 / 255));
    fill(image, 120, 70, 180, 160, static_cast<std::uint8_t>(ground + (ink - ground) / 2));
    fill(image, 20, 20, 22, 162, ink);
    fill(image, 20, 160, 280, 162, ink);
    return image;
}

TEST(ThinLines, AnAxisIsOneLineOnAnyGround) {
    for (const auto& [ground, ink] : {std::pair{255, 0}, {0, 255}}) {
        const Image image = chart(static_cast<std::uint8_t>(ground), static_cast<std::uint8_t>(ink));
        const EdgeMap map = contours(image, "contours blur=0.4mm along=0.6mm surround=0 lines=0.8mm");
        for (const int x : {60, 100, 150, 200, 250}) {
            EXPECT_EQ(edges_in_column(map, x, 150, 175), 1u) << x;
            EXPECT_EQ(edges_in_column(map, x, 159, 163), 1u) << x;
        }
        EXPECT_EQ(edges_in_column(map, 150, 60, 80), 1u);  // the bar's top
        // Two edges without it.
        EXPECT_NE(edges_in_column(contours(image, "contours blur=0.4mm along=0.6mm surround=0"), 100, 150, 175), 1u);
    }
}

TEST(ThinLines, CornersOfSurfacesStay) {
    Image image = make_image(200, 200, 1, kPixel, 255);
    fill(image, 50, 50, 150, 150, 0);
    const EdgeMap with = contours(image, "contours blur=0.4mm along=0.6mm surround=0 lines=0.8mm"),
                  without = contours(image, "contours blur=0.4mm along=0.6mm surround=0");
    EXPECT_EQ(with.strength, without.strength);
}

// A blue bar with a dark border of two pixels that stands on an axis, which is nearly the last thing of the picture.
Image bar(double mm) {
    Image image = make_image(160, 100, 3, mm, 255);
    const auto paint = [&](int left, int top, int right, int bottom, std::array<std::uint8_t, 3> colour) {
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) std::copy(colour.begin(), colour.end(), image.row(y) + 3 * x);
    };
    paint(10, 92, 150, 94, {40, 40, 40});
    paint(40, 30, 100, 94, {38, 38, 38});
    paint(42, 32, 98, 92, {68, 114, 196});
    paint(40, 94, 100, 95, {189, 189, 189});
    return image;
}

TEST(ThinLines, ABarIsClosedHoweverLargeItsPixelsAre) {
    for (const double mm : {0.12, 0.17, 0.25, 0.33, 0.37, 0.41, 0.5, 0.6}) {
        const EdgeMap map = contours(bar(mm), "contours blur=0.4mm along=0.6mm surround=0 lines=0.8mm");
        const double scale = map.width / 160.0;
        const auto is_drawn = [&](double x, double y) {
            const int reach = static_cast<int>(std::ceil(std::max(3 * scale, 1 / map.mm_per_pixel)));
            for (int v = static_cast<int>(y * scale) - reach; v <= static_cast<int>(y * scale) + reach; ++v)
                for (int u = static_cast<int>(x * scale) - reach; u <= static_cast<int>(x * scale) + reach; ++u)
                    if (u >= 0 && v >= 0 && u < map.width && v < map.height &&
                        map.strength[static_cast<std::size_t>(v * map.width + u)] > 0)
                        return true;
            return false;
        };
        for (double x = 46; x < 95; x += 2) {
            EXPECT_TRUE(is_drawn(x, 31)) << mm << " top at " << x;
            EXPECT_TRUE(is_drawn(x, 93.5)) << mm << " foot at " << x;
        }
        for (double y = 36; y < 88; y += 2)
            for (const double x : {41.0, 99.0}) EXPECT_TRUE(is_drawn(x, y)) << mm << " side at " << y;
    }
}

// Finer pixels would part the two sides of the lines around a hatch, and parts of them were left out.
TEST(ThinLines, NearlyFinePixelsAreNotMadeFiner) {
    const auto width = [](double mm) {
        return contours(bar(mm), "contours blur=0.4mm along=0.6mm surround=0 lines=0.8mm").width;
    };
    EXPECT_EQ(width(0.17), 160);
    EXPECT_EQ(width(0.28), 160);
    EXPECT_GT(width(0.37), 160);
}

}  // namespace
}  // namespace tactics::thin_lines_test
