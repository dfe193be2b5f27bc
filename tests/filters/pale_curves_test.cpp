// SPDX-License-Identifier: Apache-2.0
// Curves that one cut between ink and ground would lose.
#include "filters/pale_curves.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "filters/darken.h"
#include "tests/filters/pictures.h"

namespace tactics::pale_curves_test {
namespace {

constexpr std::array<int, 3> kWhite{255, 255, 255};

double wave(int x) { return 160 + 50 * std::sin(x / 50.0); }

// Beside a black frame and a black curve, something else.
Image with(const std::function<int(int, int)>& other) {
    return pictures::drawn(400, 300, [&](int x, int y) {
        const bool frame = (x == 20 || x == 380 || y == 20 || y == 280) && x >= 20 && x <= 380 && y >= 20 && y <= 280;
        const bool curve = x > 20 && x < 380 && std::abs(y - 60 - 0.2 * (x - 20)) < 1.5;
        return frame || curve ? 0 : other(x, y);
    });
}

Image deepened(const std::function<int(int, int)>& other) {
    Image picture = with(other);
    deepen_pale_curves(picture, ink_on_white(picture), kWhite);
    return picture;
}

TEST(PaleCurves, BecomeAsDarkAsTheInk) {
    const Image picture = deepened([](int x, int y) { return x > 25 && x < 375 && std::abs(y - wave(x)) < 1 ? 180 : 255; });
    int there = 0;
    for (int x = 60; x < 340; ++x) there += picture.row(static_cast<int>(std::lround(wave(x))))[x] < 60 ? 1 : 0;
    EXPECT_GT(there, 230);
    EXPECT_EQ(picture.row(150)[30], 255);
}

TEST(PaleCurves, GridsFramesSurfacesAndShortPiecesStayAsTheyAre) {
    const auto stays = [](const std::function<int(int, int)>& other) { return deepened(other).pixels == with(other).pixels; };
    EXPECT_TRUE(stays([](int, int) { return 255; }));
    EXPECT_TRUE(stays([](int x, int y) {
        return x > 24 && x < 376 && y > 24 && y < 276 && (x % 60 == 50 || y % 60 == 50) ? 180 : 255;
    })) << "a grid";
    EXPECT_TRUE(stays([](int x, int y) {
        const bool frame = x >= 60 && x <= 200 && y >= 190 && y <= 250 && (x == 60 || x == 200 || y == 190 || y == 250);
        return frame ? 180 : 255;
    })) << "the frame of a legend";
    EXPECT_TRUE(stays([](int x, int y) { return std::hypot(x - 200, y - 210) < 50 ? 200 : 255; })) << "a surface";
    EXPECT_TRUE(stays([](int x, int y) { return x > 100 && x < 150 && std::abs(y - wave(x)) < 1 ? 180 : 255; }))
        << "a short piece";
    pictures::Chance chance(3);
    Image scan = with([&](int x, int y) { return std::abs(y - wave(x)) < 1 ? 180 : 240 + chance.below(16); });
    const Image before = scan;
    deepen_pale_curves(scan, ink_on_white(scan), kWhite);
    EXPECT_EQ(scan.pixels, before.pixels) << "grain";
}

}  // namespace
}  // namespace tactics::pale_curves_test
