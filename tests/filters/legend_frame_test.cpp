// SPDX-License-Identifier: Apache-2.0
// The frame of a legend whose words stand elsewhere.
#include "filters/legend_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/filters/pictures.h"

namespace tactics::legend_frame_test {
namespace {

const std::vector<PixelBox> kLegend = {{60, 60, 90, 72}, {110, 58, 160, 74}, {60, 90, 90, 102}, {110, 88, 160, 104}};
constexpr double kHeight = 16;
constexpr PixelBox kFrame = {50, 48, 170, 114};

void line(Image& picture, const PixelBox& box, int level) {
    for (int y = box.top; y < box.bottom; ++y) std::fill_n(picture.row(y) + box.left, box.width(), level);
}

// Two samples in a frame; words are painted over.
Image framed(int level, int thick) {
    Image picture = make_image(300, 240, 1, pictures::kPixel, 255);
    line(picture, kLegend[0], 60);
    line(picture, kLegend[2], 150);
    line(picture, {kFrame.left, kFrame.top, kFrame.left + thick, kFrame.bottom}, level);
    line(picture, {kFrame.right - thick, kFrame.top, kFrame.right, kFrame.bottom}, level);
    line(picture, {kFrame.left, kFrame.top, kFrame.right, kFrame.top + thick}, level);
    line(picture, {kFrame.left, kFrame.bottom - thick, kFrame.right, kFrame.bottom}, level);
    return picture;
}

// What is left of ink where neither samples nor those boxes are.
int left_of(const Image& picture, std::vector<PixelBox> boxes) {
    boxes.insert(boxes.end(), kLegend.begin(), kLegend.end());
    int left = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            left += picture.row(y)[x] < 255 && std::none_of(boxes.begin(), boxes.end(), [&](const PixelBox& box) {
                        return x >= box.left && x < box.right && y >= box.top && y < box.bottom;
                    });
    return left;
}

TEST(LegendFrame, ItsFourSidesAreAllOfIt) {
    for (const int level : {0, 120, 214})
        for (const int thick : {1, 2, 4}) {
            const Image picture = framed(level, thick);
            const auto sides = legend_frame(picture, kLegend, kHeight);
            EXPECT_EQ(sides.size(), 4u) << level << ' ' << thick;
            EXPECT_EQ(left_of(picture, sides), 0) << level << ' ' << thick;
        }
}

// Its corner is that of the axes; a tick ends there, too.
TEST(LegendFrame, WhatGoesOnAsAnAxisStays) {
    Image picture = framed(0, 2);
    line(picture, {kFrame.left, kFrame.top, kFrame.left + 2, 220}, 0);
    line(picture, {kFrame.left - 12, kFrame.top, kFrame.left, kFrame.top + 2}, 0);
    const auto sides = legend_frame(picture, kLegend, kHeight);
    EXPECT_EQ(sides.size(), 3u);
    for (const PixelBox& side : sides) EXPECT_GE(side.left, kFrame.left + 4);
}

// Thin and thick are for letters to say.
TEST(LegendFrame, OfAHugePictureItIsAsThick) {
    constexpr int kTimes = 10;
    const Image small = framed(0, 2);
    Image huge = make_image(small.width * kTimes, small.height * kTimes, 1, pictures::kPixel, 255);
    for (int y = 0; y < huge.height; ++y)
        for (int x = 0; x < huge.width; ++x) huge.row(y)[x] = small.row(y / kTimes)[x / kTimes];
    std::vector<PixelBox> legend = kLegend;
    for (PixelBox& box : legend) box = {box.left * kTimes, box.top * kTimes, box.right * kTimes, box.bottom * kTimes};
    EXPECT_EQ(legend_frame(huge, legend, kTimes * kHeight).size(), 4u);
    EXPECT_TRUE(legend_frame(framed(0, 8), kLegend, kHeight).empty());
}

TEST(LegendFrame, AFrameWithMoreInItStays) {
    Image picture = framed(0, 2);
    line(picture, {64, 78, 150, 80}, 0);
    EXPECT_TRUE(legend_frame(picture, kLegend, kHeight).empty());
}

TEST(LegendFrame, ThreeSidesAreNone) {
    Image picture = framed(0, 2);
    line(picture, {kFrame.left, kFrame.bottom - 2, kFrame.right, kFrame.bottom}, 255);
    EXPECT_TRUE(legend_frame(picture, kLegend, kHeight).empty());
    EXPECT_TRUE(legend_frame(picture, {}, kHeight).empty());
}

}  // namespace
}  // namespace tactics::legend_frame_test
