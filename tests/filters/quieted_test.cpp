// SPDX-License-Identifier: Apache-2.0
// Noise of a scan goes, and what is drawn stays.
#include "filters/quieted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "filters/darken.h"
#include "filters/known_parts.h"
#include "tactics/measure/disturbance.h"

namespace tactics::quieted_test {
namespace {

constexpr int kPaper = 242, kFill = 170, kPaler = 200, kPaleLine = 182;

// As a scanned bar chart: a frame of thin pale lines, a bar on the left, and one of two greys on the right.
int chart(int x, int y) {
    const bool across = x >= 20 && x < 380, down = y >= 20 && y < 280;
    if (across && down && (x < 22 || x >= 378 || y < 22 || y >= 278)) return kPaleLine;
    if (y < 100 || y >= 278) return kPaper;
    if (x >= 80 && x < 160) return kFill;
    if (x >= 220 && x < 300) return y < 190 ? kPaler : kFill;
    return kPaper;
}

// In colour the green is as drawn, and the others are paler.
Image scanned(double deviation, int channels = 1) {
    Image picture = make_image(400, 300, channels, 0.3, 0);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < channels; ++c)
                picture.row(y)[x * channels + c] =
                    static_cast<std::uint8_t>(channels == 1 || c == 1 ? chart(x, y) : (chart(x, y) + kPaper) / 2);
    return deviation > 0 ? with_noise(std::move(picture), deviation, 5) : picture;
}

struct Mean {
    double value = 0, deviation = 0;
};
Mean mean_of(const Image& picture, int left, int top, int right, int bottom, int channel = 0) {
    double sum = 0, squares = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const double level = picture.row(y)[x * picture.channels + channel];
            sum += level;
            squares += level * level;
        }
    const double count = (right - left) * (bottom - top);
    return {sum / count, std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)))};
}

TEST(Quieted, WithoutNoiseNothingChanges) {
    for (const int channels : {1, 3}) {
        Image picture = scanned(0, channels);
        const Image before = picture;
        quieten(picture);
        EXPECT_EQ(picture.pixels, before.pixels);
    }
}

TEST(Quieted, SurfacesBecomeEvenAndKeepTheirLevels) {
    for (const double deviation : {3.0, 7.0, 10.0}) {
        Image picture = scanned(deviation);
        quieten(picture);
        for (const auto& [left, top, level] : {std::array{90, 110, kFill}, {230, 110, kPaler}, {310, 110, kPaper}}) {
            const Mean mean = mean_of(picture, left, top, left + 60, top + 70);
            EXPECT_NEAR(mean.value, level, 1) << deviation;
            EXPECT_LT(mean.deviation, 0.35 * deviation) << deviation;
        }
    }
}

TEST(Quieted, BordersStaySharpAndPaleLinesStay) {
    for (const double deviation : {3.0, 7.0}) {
        Image picture = scanned(deviation);
        quieten(picture);
        // A pixel from the border on either side, along its whole length.
        EXPECT_LT(mean_of(picture, 81, 110, 82, 270).value, kFill + 8) << deviation;
        EXPECT_GT(mean_of(picture, 77, 110, 78, 270).value, kPaper - 8) << deviation;
        EXPECT_LT(mean_of(picture, 230, 192, 290, 193).value, (kFill + kPaler) / 2) << deviation;
        EXPECT_GT(mean_of(picture, 230, 187, 290, 188).value, (kFill + kPaler) / 2) << deviation;
        EXPECT_LT(mean_of(picture, 170, 20, 210, 22).value, kPaper - 0.6 * (kPaper - kPaleLine)) << deviation;
    }
}

// The line of two pixels keeps most of its depth, as the thin part of a letter has to.
TEST(Quieted, LinesOfPrintStayWhereLessIsSmoothed) {
    for (const double deviation : {3.0, 7.0}) {
        Image picture = scanned(deviation);
        EXPECT_TRUE(quieten_lines(picture)) << deviation;
        EXPECT_LT(mean_of(picture, 90, 110, 150, 180).deviation, 0.5 * deviation) << deviation;
        EXPECT_LT(mean_of(picture, 170, 20, 210, 22).value, kPaper - 0.75 * (kPaper - kPaleLine)) << deviation;
    }
    Image clean = scanned(0);
    const Image before = clean;
    EXPECT_FALSE(quieten_lines(clean));
    EXPECT_EQ(clean.pixels, before.pixels);
}

// As where a scan was enlarged: each pixel is the mean of the four around it.
TEST(Quieted, CoarserNoiseGoesToo) {
    Image picture = scanned(12);
    const Image before = picture;
    for (int y = 0; y + 1 < picture.height; ++y)
        for (int x = 0; x + 1 < picture.width; ++x)
            picture.row(y)[x] = static_cast<std::uint8_t>(
                (before.row(y)[x] + before.row(y)[x + 1] + before.row(y + 1)[x] + before.row(y + 1)[x + 1] + 2) / 4);
    const double was = mean_of(picture, 90, 110, 150, 180).deviation;
    quieten(picture);
    EXPECT_LT(mean_of(picture, 90, 110, 150, 180).deviation, 0.5 * was);
}

TEST(Quieted, EveryChannelIs) {
    Image picture = scanned(6, 3);
    quieten(picture);
    for (int c = 0; c < 3; ++c) EXPECT_LT(mean_of(picture, 90, 110, 150, 180, c).deviation, 2.5) << c;
}

TEST(Quieted, SurfacesOfAScanHaveNoMarks) {
    Image picture = scanned(7);
    const KnownParts parts = take_known_parts(picture, ground_of(picture));
    EXPECT_TRUE(parts.strokes.empty()) << parts.strokes.size();
    EXPECT_EQ(parts.areas.size(), 3u) << "the three surfaces, of two kinds";
}

}  // namespace
}  // namespace tactics::quieted_test
