// SPDX-License-Identifier: Apache-2.0
// Words of a legend, its samples, and curves without colour.
#include "filters/inked_legend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
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

using TestColour = std::array<std::uint8_t, 3>;
constexpr TestColour kRed = {220, 30, 30}, kBlue = {30, 60, 200};

void paint(Image& picture, const PixelBox& box, const TestColour& colour) {
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) std::copy(colour.begin(), colour.end(), picture.row(y) + 3 * x);
}

// Samples at 40 and 70 from the top, with words at the right of them.
Image two_samples(const TestColour& first, const TestColour& second) {
    Image picture = make_image(400, 340, 3, 0, 255);
    paint(picture, {40, 38, 90, 42}, first);
    paint(picture, {40, 68, 90, 72}, second);
    return picture;
}
const std::vector<LegendWords> kTwoWords = {{{106, 32, 150, 48}, 16}, {{106, 62, 150, 78}, 16}};

// The first one's curve is level at 182 from the top, the second one's at 262.
Image two_curves(const TestColour& first, const TestColour& second) {
    Image picture = two_samples(first, second);
    paint(picture, {20, 180, 380, 184}, first);
    paint(picture, {20, 260, 380, 264}, second);
    return picture;
}

void expect_both_curves(const std::vector<LegendEntry>& entries) {
    ASSERT_EQ(entries.size(), 2u);
    for (const LegendEntry& entry : entries) EXPECT_NEAR(entry.at.y, entry.words == 0 ? 182 : 262, 2) << entry.words;
}

TEST(InkedLegend, ASampleMayHaveAMarkOnItsMiddle) {
    Image picture = make_image(400, 300, 3, 0, 255);
    const auto paint = [&](int x, int y, int half, std::array<std::uint8_t, 3> colour) {
        for (int v = y - half; v <= y + half; ++v) std::copy(colour.begin(), colour.end(), picture.row(v) + 3 * x);
    };
    const std::array<std::uint8_t, 3> red{220, 30, 30}, blue{30, 60, 220};
    for (int x = 20; x < 380; ++x) {
        paint(x, 250 - x / 4, x % 60 < 11 ? 5 : 1, red);
        paint(x, 120 + x / 4, x % 60 < 11 ? 5 : 1, blue);
    }
    for (int x = 30; x < 60; ++x) {
        paint(x, 20, std::abs(x - 45) < 6 ? 5 : 1, blue);
        paint(x, 40, std::abs(x - 45) < 6 ? 5 : 1, red);
    }
    const auto entries = legend_in(picture, {{{66, 14, 120, 26}, 12}, {{66, 34, 120, 46}, 12}});
    ASSERT_EQ(entries.size(), 2u);
    for (const LegendEntry& entry : entries)
        EXPECT_NEAR(entry.at.y, entry.words == 0 ? 120 + entry.at.x / 4 : 250 - entry.at.x / 4, 6);
}

// JPEG leaves of its pale line what is a little darker than the rest of it.
TEST(InkedLegend, PiecesOfItsFrameAreNoSamples) {
    Image picture = two_curves(kRed, kBlue);
    for (const int y : {26, 84})
        for (int x = 24; x < 160; x += 7) paint(picture, {x, y, x + 4, y + 1}, {205, 205, 205});
    expect_both_curves(legend_in(picture, kTwoWords));
}

TEST(InkedLegend, ASampleBelongsToTheNearestWords) {
    std::vector<LegendWords> words = kTwoWords;
    words.push_back({{2, 60, 12, 76}, 16});
    expect_both_curves(legend_in(two_curves(kRed, kBlue), words));
}

TEST(InkedLegend, ACurveMayRunByBesideASample) {
    Image picture = two_curves(kRed, kBlue);
    paint(picture, {4, 82, 30, 84}, kRed);
    expect_both_curves(legend_in(picture, kTwoWords));
}

// Words in boxes, and arrows that end at these.
TEST(InkedLegend, ABorderPartsASampleFromItsWords) {
    Image picture = two_curves(kRed, kBlue);
    paint(picture, {97, 4, 99, 120}, {0, 0, 0});
    EXPECT_TRUE(legend_in(picture, kTwoWords).empty());
}

// Of arrows, with words beside their middles.
TEST(InkedLegend, NoSampleGoesOnInDashes) {
    for (const bool goes_on : {false, true}) {
        Image picture = make_image(400, 340, 3, 0, 255);
        const auto dashed = [&](int left, int y, int length, int step, const TestColour& colour) {
            for (int x = left; x + length <= (y < 100 ? 90 : 380); x += step) paint(picture, {x, y, x + length, y + 3}, colour);
        };
        for (const int y : {38, 180}) dashed(y > 100 ? 20 : goes_on ? 11 : 40, y, 10, 20, kRed);
        for (const int y : {68, 260}) dashed(y > 100 ? 20 : goes_on ? 5 : 41, y, 3, 9, kBlue);
        std::vector<LegendWords> words = kTwoWords;
        for (LegendWords& one : words) one.height = 11;
        EXPECT_EQ(legend_in(picture, words).size(), goes_on ? 0u : 2u);
    }
}

TEST(InkedLegend, DashesMayDifferByTheirLengthsAlone) {
    constexpr TestColour kBlack = {0, 0, 0};
    const auto legend = [&](int second, int second_step) {
        Image picture = make_image(400, 340, 3, 0, 255);
        const auto dashed = [&](int left, int y, int length, int step) {
            for (int x = left; x + length <= (y < 100 ? 90 : 380); x += step) paint(picture, {x, y, x + length, y + 3}, kBlack);
        };
        for (const int y : {38, 180}) dashed(y > 100 ? 20 : 40, y, 14, 22);
        for (const int y : {68, 260}) dashed(y > 100 ? 20 : 41, y, second, second_step);
        std::vector<LegendWords> words = kTwoWords;
        for (LegendWords& one : words) one.height = 11;
        return legend_in(picture, words);
    };
    const auto entries = legend(7, 11);
    ASSERT_EQ(entries.size(), 2u);
    for (const LegendEntry& entry : entries) EXPECT_NEAR(entry.at.y, entry.words == 0 ? 181.5 : 261.5, 4) << entry.words;
    EXPECT_TRUE(legend(14, 22).empty()) << "which is which nobody knows";
}

// Half of its line is in each of two rows of pixels, and the curve is in whole ones.
TEST(InkedLegend, AThinSampleIsPalerThanItsCurve) {
    Image picture = make_image(400, 340, 3, 0, 255);
    const auto half = [](const TestColour& colour) {
        TestColour pale = colour;
        for (auto& channel : pale) channel = static_cast<std::uint8_t>((255 + channel) / 2);
        return pale;
    };
    for (const auto& [y, colour, at] : {std::tuple{38, kRed, 180}, std::tuple{68, kBlue, 260}}) {
        paint(picture, {40, y, 90, y + 2}, half(colour));
        for (int x = 20; x < 380; ++x) paint(picture, {x, at + x / 8, x + 1, at + x / 8 + 1}, colour);
    }
    const auto entries = legend_in(picture, kTwoWords);
    ASSERT_EQ(entries.size(), 2u);
    for (const LegendEntry& entry : entries) EXPECT_NEAR(entry.at.y, (entry.words == 0 ? 180 : 260) + entry.at.x / 8, 2);
}

// What dashes a mark covers nobody sees, but their colour.
TEST(InkedLegend, ADashedSampleMayHaveAMark) {
    Image picture = make_image(400, 340, 3, 0, 255);
    for (const auto& [y, colour, at] : {std::tuple{38, kRed, 180}, std::tuple{68, kBlue, 260}}) {
        for (int x = 30; x < 90; x += 10) paint(picture, {x, y, x + 6, y + 2}, colour);
        paint(picture, {55, y - 5, 67, y + 7}, colour);
        for (int x = 20; x < 360; x += 30) paint(picture, {x, at, x + 24, at + 2}, colour);
        for (int x = 40; x < 380; x += 60) paint(picture, {x, at - 5, x + 12, at + 7}, colour);
    }
    const auto entries = legend_in(picture, kTwoWords);
    ASSERT_EQ(entries.size(), 2u);
    for (const LegendEntry& entry : entries) EXPECT_NEAR(entry.at.y, entry.words == 0 ? 181 : 261, 7) << entry.words;
}

// Pale dashes with blurred ends on black.
TEST(InkedLegend, DashesMayBeLight) {
    Image picture = make_image(400, 340, 3, 0, 0);
    const auto dashed = [&](int left, int right, int y, int length, int step, const TestColour& colour) {
        for (int x = left; x + length <= right; x += step) {
            paint(picture, {x - 1, y - 1, x + length + 1, y + 4},
                  {static_cast<std::uint8_t>(colour[0] / 3), static_cast<std::uint8_t>(colour[1] / 3),
                   static_cast<std::uint8_t>(colour[2] / 3)});
            paint(picture, {x, y, x + length, y + 3}, colour);
        }
    };
    constexpr TestColour kYellow = {255, 255, 180}, kPurple = {190, 185, 215};
    dashed(40, 90, 38, 10, 20, kYellow), dashed(20, 380, 180, 10, 20, kYellow);
    dashed(41, 90, 68, 3, 9, kPurple), dashed(20, 380, 260, 3, 9, kPurple);
    std::vector<LegendWords> words = kTwoWords;
    for (LegendWords& one : words) one.height = 11;
    const auto entries = legend_in(picture, words);
    ASSERT_EQ(entries.size(), 2u);
    for (const LegendEntry& entry : entries) EXPECT_NEAR(entry.at.y, entry.words == 0 ? 181.5 : 261.5, 4) << entry.words;
}

// Boxes that touch each other, higher than the rows of their words; full ones show surfaces, borders curves.
TEST(InkedLegend, BoxesMayTouchEachOther) {
    for (const bool full : {true, false}) {
        Image picture = make_image(400, 340, 3, 0, 255);
        const auto box = [&](int left, int top, int right, int bottom, const TestColour& colour) {
            paint(picture, {left, top, right, bottom}, colour);
            if (!full) paint(picture, {left + 3, top + 3, right - 3, bottom - 3}, {255, 255, 255});
        };
        box(40, 20, 72, 52, kRed);
        box(40, 52, 72, 84, kBlue);
        if (full) {
            paint(picture, {100, 150, 180, 300}, kRed);
            paint(picture, {200, 200, 280, 300}, kBlue);
        } else {
            paint(picture, {20, 180, 380, 184}, kRed);
            paint(picture, {20, 260, 380, 264}, kBlue);
        }
        const std::vector<LegendWords> words = {{{80, 30, 130, 42}, 12}, {{80, 62, 130, 74}, 12}};
        const auto entries = legend_in(picture, words);
        if (!full) {
            expect_both_curves(entries);
            continue;
        }
        ASSERT_EQ(entries.size(), 2u);
        EXPECT_NEAR(entries[0].at.x, 140, 2);
        EXPECT_NEAR(entries[1].at.x, 240, 2);
        EXPECT_EQ(entries[0].sample, (PixelBox{40, 20, 72, 52}));
    }
}

// Pieces of the picture beside words are none.
TEST(InkedLegend, BoxesOfOtherShapesAreNoSamples) {
    Image picture = make_image(400, 340, 3, 0, 255);
    for (const int top : {20, 52}) {
        const TestColour& colour = top == 20 ? kRed : kBlue;
        for (int y = 0; y < 32; ++y) paint(picture, {40 + y / 2, top + y, 72, top + y + 1}, colour);
        paint(picture, {100 + 4 * top, 150, 180 + 4 * top, 300}, colour);
    }
    EXPECT_TRUE(legend_in(picture, {{{80, 30, 130, 42}, 12}, {{80, 62, 130, 74}, 12}}).empty());
}

TEST(InkedLegend, ItMayStandOnAPanel) {
    Image picture = two_curves(kRed, kBlue);
    for (int y = 20; y < 90; ++y)
        for (int x = 30; x < 170; ++x)
            if (picture.row(y)[3 * x] == 255) std::fill_n(picture.row(y) + 3 * x, 3, 190);
    expect_both_curves(legend_in(picture, kTwoWords));
}

// As JPEG mixes two colours of thin lines with the ground.
TEST(InkedLegend, ColoursMayBeNearEachOther) {
    expect_both_curves(legend_in(two_curves({108, 134, 169}, {117, 167, 135}), kTwoWords));
}

// On a slope no pixel of it has the whole colour.
TEST(InkedLegend, AThinCurveIsPalerThanItsSample) {
    Image picture = two_samples(kRed, kBlue);
    for (int x = 20; x < 380; ++x) {
        const double y = 150 + 0.4 * x;
        for (const int row : {static_cast<int>(y), static_cast<int>(y) + 1}) {
            const double ink = std::min(0.6, 1 - std::abs(row - y));
            for (std::size_t c = 0; c < 3; ++c) {
                picture.row(row)[3 * x + static_cast<int>(c)] = static_cast<std::uint8_t>(255 - ink * (255 - kRed[c]));
                picture.row(row - 60)[3 * x + static_cast<int>(c)] = static_cast<std::uint8_t>(255 - ink * (255 - kBlue[c]));
            }
        }
    }
    const auto entries = legend_in(picture, kTwoWords);
    ASSERT_EQ(entries.size(), 2u);
    for (const LegendEntry& entry : entries)
        EXPECT_NEAR(entry.at.y, (entry.words == 0 ? 150 : 90) + 0.4 * entry.at.x, 3) << entry.words;
}

}  // namespace
}  // namespace tactics::inked_legend_test
