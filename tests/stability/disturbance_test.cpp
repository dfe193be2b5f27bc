// SPDX-License-Identifier: Apache-2.0
// The changes are what they say, and the way back leads where the picture was.
#include "tactics/measure/disturbance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tactics/measure/stability.h"

namespace tactics::disturbance_test {
namespace {

constexpr int kWidth = 300, kHeight = 200;

const Disturbance& named(std::string_view name) {
    const auto all = disturbances();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Disturbance& d) { return d.name.text == name; });
    EXPECT_NE(found, all.end()) << name;
    return *found;
}

std::uint32_t at(int x, int y, int width = kWidth) { return static_cast<std::uint32_t>(y * width + x); }

Image spot(int x, int y) {
    Image image = make_image(kWidth, kHeight, 1, 0, 0);
    for (int dy = 0; dy < 4; ++dy)
        for (int dx = 0; dx < 4; ++dx) image.row(y + dy)[x + dx] = 255;
    return image;
}

struct Middle {
    double x = 0, y = 0;
};

Middle of_light(const Image& image) {
    double x = 0, y = 0, sum = 0;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const double light = image.row(row)[column] > 60 ? image.row(row)[column] : 0;
            x += light * (column + 0.5);
            y += light * (row + 0.5);
            sum += light;
        }
    return {x / sum, y / sum};
}

TEST(Disturbance, TheWayBackLeadsToWhereThePictureWas) {
    for (const Disturbance& disturbance : disturbances())
        for (const auto& [x, y] : {std::pair{60, 30}, {240, 40}, {150, 100}, {40, 150}, {250, 160}}) {
            if (disturbance.name.text == "dark 0.1" || disturbance.name.text == "very low" || disturbance.name.text == "low")
                continue;
            const Disturbed changed = disturbance.apply(spot(x, y));
            const Middle seen = of_light(changed.image);
            const PixelSet lines{changed.width,
                                 changed.height,
                                 {at(static_cast<int>(seen.x * changed.width / changed.image.width),
                                     static_cast<int>(seen.y * changed.height / changed.image.height), changed.width)}};
            const PixelSet back = brought_back(lines, changed, kWidth, kHeight);
            ASSERT_EQ(back.pixels.size(), 1u) << disturbance.name.text;
            EXPECT_NEAR(static_cast<double>(back.pixels[0] % kWidth), x + 1.5, 1) << disturbance.name.text;
            EXPECT_NEAR(static_cast<double>(back.pixels[0] / kWidth), y + 1.5, 1) << disturbance.name.text;
        }
}

TEST(Disturbance, TonesAreWhatTheHelpSays) {
    Image image = make_image(2, 1, 1, 0, 0);
    image.pixels = {200, 20};
    const auto first = [&](std::string_view name, std::size_t i) {
        return static_cast<int>(named(name).apply(image).image.pixels[i]);
    };
    EXPECT_EQ(first("dark 0.1", 0), 20);
    EXPECT_EQ(first("dark 0.3", 1), 6);
    EXPECT_NEAR(first("low", 0), 164, 1);
    EXPECT_NEAR(first("very low", 1), 106, 1);
    EXPECT_EQ(first("gamma 0.8", 0), std::lround(255 * std::pow(200 / 255.0, 0.8)));
    EXPECT_GT(first("gamma 0.8", 1), 20);
}

TEST(Disturbance, NoiseHasItsDeviationAndIsTheSameAgain) {
    const Image grey = make_image(kWidth, kHeight, 3, 0.5, 128);
    const Image noisy = named("noise 10").apply(grey).image;
    double sum = 0, squares = 0;
    for (const std::uint8_t value : noisy.pixels) {
        sum += value - 128.0;
        squares += (value - 128.0) * (value - 128.0);
    }
    const auto count = static_cast<double>(noisy.pixels.size());
    EXPECT_NEAR(sum / count, 0, 0.1);
    EXPECT_NEAR(std::sqrt(squares / count), 10, 0.1);
    EXPECT_EQ(named("noise 10").apply(grey).image.pixels, noisy.pixels);
    EXPECT_NE(with_noise(grey, 10, 2).pixels, noisy.pixels);
    EXPECT_EQ(noisy.mm_per_pixel, 0.5);
}

TEST(Disturbance, WorseJpegIsFartherFromThePicture) {
    const Image image = with_noise(spot(100, 100), 30, 5);
    const auto error = [&](std::string_view name) {
        const Image stored = named(name).apply(image).image;
        EXPECT_EQ(stored.pixels.size(), image.pixels.size());
        double squares = 0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) squares += std::pow(stored.pixels[i] - image.pixels[i], 2);
        return std::sqrt(squares / static_cast<double>(image.pixels.size()));
    };
    EXPECT_GT(error("JPEG 70"), 1);
    EXPECT_GT(error("JPEG 50"), error("JPEG 70"));
    EXPECT_LT(error("JPEG 50"), 30);
}

TEST(Stability, AgreementIsOneForTheSameAndNothingForOneAlone) {
    PixelSet column{kWidth, kHeight, {}}, near = column, far = column, half = column;
    const PixelSet none = column;
    for (int y = 0; y < kHeight; ++y) {
        column.pixels.push_back(at(100, y));
        near.pixels.push_back(at(102, y));  // 0.75 % of the diagonal is 2.7 pixels
        far.pixels.push_back(at(103, y));
        if (y < kHeight / 2) half.pixels.push_back(at(100, y));
    }
    EXPECT_EQ(agreement(column, column), 1);
    EXPECT_EQ(agreement(column, near), 1);
    EXPECT_EQ(agreement(column, far), 0);
    EXPECT_NEAR(agreement(column, half), 2.0 / 3, 0.02);  // precision 1, recall a half
    EXPECT_EQ(agreement(column, half), agreement(half, column));
    EXPECT_EQ(agreement(column, none), 0);
    EXPECT_EQ(agreement(none, column), 0);
    EXPECT_EQ(agreement(none, none), 1);
}

TEST(Stability, WhatOnlyOneOfThePicturesShowsIsNotAsked) {
    const Disturbed crop = named("crop").apply(make_image(kWidth, kHeight, 1, 0, 0));
    const PixelSet lines{kWidth, kHeight, {at(5, 100), at(16, 100), at(30, 100), at(290, 100)}};
    EXPECT_EQ(seen_by_both(lines, crop, 3).pixels, (std::vector{at(30, 100)}));
    const Disturbed dark = named("dark 0.1").apply(make_image(kWidth, kHeight, 1, 0, 0));
    EXPECT_EQ(seen_by_both(lines, dark, 3).pixels, lines.pixels);
}

}  // namespace
}  // namespace tactics::disturbance_test
