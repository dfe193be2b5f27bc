// SPDX-License-Identifier: Apache-2.0
// Contours of drawn pictures: thin lines by their middle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "filters/components.h"
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

constexpr float kClear = 40;  // recipe diagram

std::size_t pieces_of(const EdgeMap& map) {
    return find_components(map.width, map.height, Joined::by_corners, [&](std::size_t i) { return map.strength[i] >= kClear; })
        .count;
}

// Pixels as coarse as the blur: what is drawn large from a small picture.
TEST(ThinLines, BarsAreJoinedToTheAxisTheyStandOn) {
    for (const int mark : {0, 60}) {  // black, or dark
        Image image = make_image(200, 130, 1, 0.35, 255);
        for (const int left : {40, 110}) fill(image, left, 30, left + 40, 120, static_cast<std::uint8_t>(mark));
        fill(image, 10, 120, 190, 122, 0);
        const EdgeMap map = contours(image, "contours blur=0.4mm along=0.6mm surround=0 lines=0.8mm");
        EXPECT_EQ(pieces_of(map), 1u) << mark;
    }
}

TEST(ThinLines, AnOutlineBetweenAColourAndTheGroundIsOneLine) {
    Image image = make_image(200, 130, 3, 0.35, 255);
    const auto paint = [&](int left, int top, int right, int bottom, std::array<std::uint8_t, 3> colour) {
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) std::copy(colour.begin(), colour.end(), image.row(y) + 3 * x);
    };
    paint(50, 30, 150, 100, {189, 189, 189});
    paint(51, 31, 149, 99, {38, 38, 38});
    paint(53, 33, 147, 97, {68, 114, 196});
    const EdgeMap map = contours(image, "contours blur=0.4mm along=0.6mm surround=0 lines=0.8mm");
    EXPECT_EQ(edges_in_column(map, 100, 90, 110), 1u);
    EXPECT_EQ(edges_in_column(map, 100, 20, 40), 1u);
}

}  // namespace
}  // namespace tactics::thin_lines_test
