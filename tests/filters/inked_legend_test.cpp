// SPDX-License-Identifier: Apache-2.0
// Words of a legend, its samples, and curves without colour.
#include "filters/inked_legend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/filters/pictures.h"

namespace tactics::inked_legend_test {
namespace {

// With soft borders: each pixel is looked at in sixteen places.
template <typename Shape>
Image painted(Shape shape) {
    return pictures::drawn(400, 340, [&](int x, int y) {
        int black = 0;
        for (int i = 0; i < 16; ++i) black += shape(x + (i % 4 + 0.5) / 4, y + (i / 4 + 0.5) / 4) ? 1 : 0;
        return 255 - 255 * black / 16;
    });
}

// Each is painted in its own grey, and no place on the one is a place on the other.
TEST(InkedLegend, AGreyLineAndABlackOneThatCrossKeepTheirNames) {
    const auto grey_on = [](double x) { return 200 + 60 * std::sin(x / 40); };
    const auto black_on = [](double x) { return 290 - 0.4 * x; };
    for (const double half : {0.7, 1.5}) {
        const auto curve = [half](auto on, double sample) {
            return [=](double x, double y) {
                const double slope = on(x + 0.5) - on(x - 0.5);
                return (x > 20 && x < 380 && std::abs(y - on(x)) <= half * std::hypot(1, slope)) ||
                       (x > 30 && x < 75 && std::abs(y - sample) <= half);
            };
        };
        const Image pale = painted(curve(grey_on, 20)), black = painted(curve(black_on, 40)),
                    dashed = painted([](double x, double y) {
                        const bool sample = x > 30 && x < 72 && std::abs(y - 60) <= 1;
                        const bool curve = x > 30 && x < 380 && std::abs(y - 320 - 0.01 * x) <= 1;
                        return (sample || curve) && std::fmod(x - 30, 15) < 11;
                    });
        Image picture = make_image(400, 340, 1, 0, 255);
        for (std::size_t i = 0; i < picture.pixels.size(); ++i)
            picture.pixels[i] = static_cast<std::uint8_t>(
                std::min<int>({255 - (255 - pale.pixels[i]) * 2 / 5, black.pixels[i], dashed.pixels[i]}));
        const auto entries = legend_in(picture, {{{84, 14, 136, 26}, 12}, {{84, 34, 136, 46}, 12}, {{84, 54, 136, 66}, 12}});
        EXPECT_EQ(entries.size(), 3u) << half;
        for (const LegendEntry& entry : entries) {
            const double on[] = {grey_on(entry.at.x), black_on(entry.at.x), 320 + 0.01 * entry.at.x};
            EXPECT_NEAR(entry.at.y, on[entry.words], 4) << half << " " << entry.words;
        }
    }
}

// A red curve and a blue one, and at the right of their samples, at 40 and 70 from the top, their words.
Image red_and_blue() {
    Image picture = make_image(400, 340, 3, 0, 255);
    const auto paint = [&](int left, int right, int top, std::array<std::uint8_t, 3> colour) {
        for (int y = top; y < top + 4; ++y)
            for (int x = left; x < right; ++x) std::copy(colour.begin(), colour.end(), picture.row(y) + 3 * x);
    };
    for (const auto& [left, right, row] : {std::array{40, 90, 38}, {20, 380, 180}}) paint(left, right, row, {220, 30, 30});
    for (const auto& [left, right, row] : {std::array{40, 90, 68}, {20, 380, 260}}) paint(left, right, row, {30, 60, 200});
    return picture;
}

void expect_red_and_blue(const std::vector<LegendEntry>& entries) {
    ASSERT_EQ(entries.size(), 2u);
    for (const LegendEntry& entry : entries) EXPECT_NEAR(entry.at.y, entry.words == 0 ? 182 : 262, 2) << entry.words;
}

// JPEG leaves of its pale line what is a little darker than the rest of it.
TEST(InkedLegend, PiecesOfItsFrameAreNoSamples) {
    Image picture = red_and_blue();
    for (const int y : {26, 84})
        for (int x = 24; x < 160; ++x) {
            if (x % 7 < 3) continue;
            std::fill_n(picture.row(y) + 3 * x, 3, 205);
        }
    expect_red_and_blue(legend_in(picture, {{{106, 32, 150, 48}, 16}, {{106, 62, 150, 78}, 16}}));
}

TEST(InkedLegend, ASampleBelongsToTheNearestWords) {
    expect_red_and_blue(legend_in(red_and_blue(), {{{106, 32, 150, 48}, 16}, {{106, 62, 150, 78}, 16}, {{2, 60, 12, 76}, 16}}));
}

}  // namespace
}  // namespace tactics::inked_legend_test
