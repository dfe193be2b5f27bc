// SPDX-License-Identifier: Apache-2.0
// Curves that go up and down faster than a finger can follow, as they are found in pictures.
#include "filters/noisy_curves.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/filters/pictures.h"

namespace tactics::noisy_curves_test {
namespace {

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kBlue{31, 119, 180}, kRed{214, 39, 40};
constexpr int kWide = 640, kHigh = 400, kFrom = 40, kTo = 600;

Image sheet() { return make_image(kWide, kHigh, 3, 250.0 / kWide, 255); }

void dot(Image& image, int x, int y, Colour colour) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
    for (std::size_t c = 0; c < 3; ++c) image.row(y)[3 * x + static_cast<int>(c)] = colour[c];
}

// A pen of two pixels from value to value.
template <typename Value>
void draw(Image& image, Colour colour, Value value) {
    double before = value(kFrom);
    for (int x = kFrom; x < kTo; ++x) {
        const double now = value(x);
        for (int y = static_cast<int>(std::min(before, now)); y <= static_cast<int>(std::max(before, now)) + 1; ++y) {
            dot(image, x, y, colour);
            dot(image, x + 1, y, colour);
        }
        before = now;
    }
}

double trend(int x) { return 200 + 90 * std::sin(x / 90.0); }

std::vector<double> noise(std::uint64_t seed, double size) {
    pictures::Chance chance(seed);
    std::vector<double> values(kWide);
    for (double& value : values) value = size * chance.normal();
    return values;
}

TEST(NoisyCurves, TheMiddleOfTheNoiseIsDrawn) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        Image image = sheet();
        const std::vector<double> off = noise(seed, 10);
        draw(image, kBlue, [&](int x) { return trend(x) + off[static_cast<std::size_t>(x)]; });
        const std::vector<NoisyCurve> curves = noisy_curves_in(image);
        ASSERT_EQ(curves.size(), 1u) << seed;
        const std::vector<Point>& course = curves[0].course;
        EXPECT_LT(course.front().x, kFrom + 2);
        EXPECT_GT(course.back().x, kTo - 2);
        for (std::size_t i = 1; i + 1 < course.size(); ++i) {
            EXPECT_GT(course[i].x, course[i - 1].x);
            EXPECT_NEAR(course[i].y, trend(static_cast<int>(course[i].x)), 18) << seed;
        }
    }
}

TEST(NoisyCurves, CurvesThatCrossAreWhole) {
    Image image = sheet();
    const std::vector<double> one = noise(7, 9), other = noise(8, 9);
    draw(image, kBlue, [&](int x) { return 60 + 0.4 * x + one[static_cast<std::size_t>(x)]; });
    draw(image, kRed, [&](int x) { return 300 - 0.4 * x + other[static_cast<std::size_t>(x)]; });
    const std::vector<NoisyCurve> curves = noisy_curves_in(image);
    ASSERT_EQ(curves.size(), 2u);
    for (const NoisyCurve& curve : curves) {
        EXPECT_LT(curve.course.front().x, kFrom + 10);
        EXPECT_GT(curve.course.back().x, kTo - 10);
    }
}

TEST(NoisyCurves, APeakFarOutStays) {
    Image image = sheet();
    const std::vector<double> off = noise(9, 4);
    draw(image, kBlue, [&](int x) { return x == 300 ? 200.0 : 300 + off[static_cast<std::size_t>(x)]; });
    const std::vector<NoisyCurve> curves = noisy_curves_in(image);
    ASSERT_EQ(curves.size(), 1u);
    ASSERT_EQ(curves[0].spikes.size(), 1u);
    EXPECT_NEAR(curves[0].spikes[0][1].x, 300, 3);
    EXPECT_NEAR(curves[0].spikes[0][1].y, 200, 3);
}

TEST(NoisyCurves, WhatAFingerCanFollowStays) {
    for (const double period : {400.0, 120.0, 40.0}) {
        Image image = sheet();
        draw(image, kBlue, [&](int x) { return 200 + 60 * std::sin(2 * 3.14159265 * x / period); });
        EXPECT_TRUE(noisy_curves_in(image).empty()) << period;
    }
}

TEST(NoisyCurves, SurfacesPointsAndErrorBarsAreNone) {
    const std::vector<double> off = noise(11, 8), other = noise(12, 8);
    Image surface = sheet(), points = sheet(), bars = sheet(), histogram = sheet();
    for (int x = kFrom; x < kTo; ++x) {
        for (int y = static_cast<int>(trend(x) / 2 + off[static_cast<std::size_t>(x)]); y < 350; ++y) dot(surface, x, y, kBlue);
        for (int y = 350 - 20 - 20 * ((x / 12) % 7 + (x / 48) % 3); y < 350; ++y) dot(histogram, x, y, kRed);
    }
    pictures::Chance chance(13);
    for (int i = 0; i < 400; ++i) {
        const int x = kFrom + chance.below(kTo - kFrom), y = static_cast<int>(200 + 25 * chance.normal());
        for (int k = 0; k < 9; ++k) dot(points, x + k % 3, y + k / 3, kBlue);
    }
    draw(bars, kBlue, trend);
    for (int x = kFrom; x < kTo; x += 9)
        for (int y = -8; y <= 8; ++y) dot(bars, x, static_cast<int>(trend(x)) + y, kBlue);
    for (const Image* image : {&surface, &points, &bars, &histogram}) EXPECT_TRUE(noisy_curves_in(*image).empty());
}

}  // namespace
}  // namespace tactics::noisy_curves_test
