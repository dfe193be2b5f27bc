// SPDX-License-Identifier: Apache-2.0
// Dashed lines made whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/filters/pictures.h"

namespace tactics::dashes_test {
namespace {

constexpr double kPixel = 0.17;  // mm: 150 dpi

Image white() { return make_image(400, 200, 1, kPixel, 255); }

// A bar of that length from there on, 3 pixels wide, along a line that rises by a quarter.
void add_dash(Image& image, double from, double length) {
    for (double t = from; t < from + length; t += 0.25)
        for (int dy = -1; dy <= 1; ++dy) image.row(150 - static_cast<int>(t / 4) + dy)[20 + static_cast<int>(t)] = 0;
}

std::size_t gaps_along(const Image& image, double to) {
    std::size_t gaps = 0;
    for (double t = 0; t < to; ++t) gaps += image.row(150 - static_cast<int>(t / 4))[20 + static_cast<int>(t)] != 0 ? 1 : 0;
    return gaps;
}

TEST(Dashes, RowsOfDashesAndDotsBecomeLines) {
    struct Style {
        double dash, gap, dot;
    };
    for (const Style style : {Style{11, 5, 0}, Style{3, 5, 0}, Style{20, 5, 3}, Style{20, 10, 0}}) {
        Image image = white();
        double at = 0;
        while (at < 300) {
            add_dash(image, at, style.dash);
            at += style.dash + style.gap;
            if (style.dot == 0) continue;
            add_dash(image, at, style.dot);
            at += style.dot + style.gap;
        }
        const double end = 290;
        EXPECT_GT(gaps_along(image, end), 50u);
        EXPECT_LT(gaps_along(pictures::filtered_image("dashes", image), end), 12u)
            << style.dash << " " << style.gap << " " << style.dot;
    }
}

TEST(Dashes, FewPiecesLettersAndFarOnesStayAsTheyAre) {
    Image few = white();
    for (const double at : {0.0, 16.0, 32.0}) add_dash(few, at, 11);
    EXPECT_EQ(pictures::filtered_image("dashes", few).pixels, few.pixels);
    Image far = white();
    for (double at = 0; at < 300; at += 60) add_dash(far, at, 11);
    EXPECT_EQ(pictures::filtered_image("dashes", far).pixels, far.pixels);
    // As large and as close as letters: 10 by 14 pixels.
    Image letters = white();
    for (int n = 0; n < 12; ++n)
        for (int y = 100; y < 114; ++y)
            for (int x = 0; x < 10; ++x) letters.row(y)[20 + 13 * n + x] = 0;
    EXPECT_EQ(pictures::filtered_image("dashes", letters).pixels, letters.pixels);
}

}  // namespace
}  // namespace tactics::dashes_test
