// SPDX-License-Identifier: Apache-2.0
// Contours of drawn pictures: lines of a broad pen by their middle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/filters/pictures.h"

namespace tactics::thick_lines_test {
namespace {

constexpr double kFine = 0.17;  // mm: 150 dpi
constexpr const char* kStep = "contours blur=0.4mm along=0.6mm surround=0 lines=0.8mm";

EdgeMap contours(Image image) { return std::get<EdgeMap>(pictures::filtered(kStep, std::move(image))); }

double wave(double x) { return 150 + 70 * std::sin(x / 60.0); }

// A disc of that diameter along the wave.
Image with_wave(double pen, std::uint8_t ground, std::uint8_t ink) {
    Image image = make_image(500, 300, 1, kFine, ground);
    const int reach = static_cast<int>(pen / 2);
    for (double at = 30; at < 470; at += 0.25)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x)
                if (std::hypot(x, y) <= pen / 2) image.row(static_cast<int>(wave(at)) + y)[static_cast<int>(at) + x] = ink;
    return image;
}

void fill(Image& image, int left, int top, int right, int bottom, std::uint8_t grey) {
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) image.row(y)[x] = grey;
}

std::vector<int> edges_in_column(const EdgeMap& map, int x) {
    std::vector<int> rows;
    for (int y = 0; y < map.height; ++y)
        if (map.strength[static_cast<std::size_t>(y * map.width + x)] > 0 && (rows.empty() || y > rows.back() + 1))
            rows.push_back(y);
    return rows;
}

TEST(ThickLines, ABroadPenLeavesOneLineInItsMiddle) {
    for (const double pen : {8.0, 14.0, 22.0, 34.0})  // 1.4 to 5.8 mm
        for (const auto& [ground, ink] : {std::pair{255, 40}, {255, 120}, {20, 230}}) {
            const EdgeMap map = contours(with_wave(pen, static_cast<std::uint8_t>(ground), static_cast<std::uint8_t>(ink)));
            for (int x = 60; x < 440; x += 7) {
                const std::vector<int> rows = edges_in_column(map, x);
                ASSERT_EQ(rows.size(), 1u) << pen << " at " << x << " on " << ground;
                // The wave is steep: 1.2 rows a column.
                EXPECT_NEAR(rows[0] + 0.5, wave(x), 5) << pen << " at " << x;
            }
        }
}

// Yellow is as deep an ink as the border around it in one channel only, and the pen is a little broader than a thin line.
TEST(ThickLines, ABorderOfAColouredSurfaceIsOneLine) {
    constexpr double kCoarse = 0.376, kRadius = 90, kPen = 4.5;  // mm, pixels
    Image image = make_image(260, 260, 3, kCoarse, 255);
    for (int y = 0; y < 260; ++y)
        for (int x = 0; x < 260; ++x) {
            const double off = std::hypot(x + 0.5 - 130, y + 0.5 - 130) - kRadius,
                         ink = std::clamp(kPen / 2 + 0.5 - std::abs(off), 0.0, 1.0);
            const double yellow[] = {255, 233, 80};
            for (int c = 0; c < 3; ++c)
                image.row(y)[3 * x + c] = static_cast<std::uint8_t>((1 - ink) * (off < 0 ? yellow[c] : 255));
        }
    const EdgeMap map = contours(std::move(image));
    for (int x = 60; x < 200; ++x) {
        const std::vector<int> rows = edges_in_column(map, x);
        ASSERT_EQ(rows.size(), 2u) << x;
        const double away = std::sqrt(kRadius * kRadius - (x + 0.5 - 130) * (x + 0.5 - 130));
        EXPECT_NEAR(rows[0] + 0.5, 130 - away, 2) << x;
        EXPECT_NEAR(rows[1] + 0.5, 130 + away, 2) << x;
    }
}

TEST(ThickLines, AThinLineGoesOnThroughABroadOne) {
    Image image = with_wave(14, 255, 60);
    fill(image, 20, 149, 480, 151, 60);
    const EdgeMap map = contours(image);
    int without = 0;
    for (int x = 40; x < 460; ++x) {
        bool near = false;
        for (int y = 144; y <= 156; ++y) near = near || map.strength[static_cast<std::size_t>(y * map.width + x)] > 0;
        without += near ? 0 : 1;
    }
    EXPECT_LE(without, 12);  // a step between two middles, at three crossings; 2 mm are bridged
}

TEST(ThickLines, WhatHasRoomForBothEdgesHasBoth) {
    Image bars = make_image(500, 300, 1, kFine, 255);
    fill(bars, 100, 40, 130, 260, 90);  // 5.1 mm wide: a bar
    fill(bars, 300, 40, 318, 260, 90);  // 3.1 mm: its edges have no room beside each other
    const EdgeMap map = contours(bars);
    for (const int y : {80, 150, 220}) {
        int wide = 0, narrow = 0;
        for (int x = 80; x < 150; ++x) wide += map.strength[static_cast<std::size_t>(y * map.width + x)] > 0 ? 1 : 0;
        for (int x = 280; x < 340; ++x) narrow += map.strength[static_cast<std::size_t>(y * map.width + x)] > 0 ? 1 : 0;
        EXPECT_EQ(wide, 2) << y;
        EXPECT_EQ(narrow, 1) << y;
    }
}

// A wedge is of no one width, and what comes out of a surface is a part of its outline.
TEST(ThickLines, WedgesAndTowersKeepTheirOutline) {
    Image image = make_image(500, 300, 1, kFine, 255);
    for (int y = 40; y < 260; ++y) fill(image, 100 - (y - 40) / 14, y, 102 + (y - 40) / 14, y + 1, 90);
    fill(image, 260, 160, 460, 260, 90);
    fill(image, 350, 40, 370, 160, 90);  // 3.4 mm
    const EdgeMap map = contours(image);
    const auto edges_in_row = [&](int y, int from, int to) {
        int count = 0;
        for (int x = from; x < to; ++x) count += map.strength[static_cast<std::size_t>(y * map.width + x)] > 0 ? 1 : 0;
        return count;
    };
    for (const int y : {180, 220, 240}) EXPECT_EQ(edges_in_row(y, 60, 140), 2) << y;
    for (const int y : {70, 100, 130}) EXPECT_EQ(edges_in_row(y, 330, 390), 2) << y;
}

}  // namespace
}  // namespace tactics::thick_lines_test
