// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/lines.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tactics::lines_test {
namespace {

using Pixels = std::vector<std::uint32_t>;

PixelSet all_of(const Artwork& artwork, int width, int height) { return cut_at(lines_of(artwork, width, height), 0); }

Drawing sheet(double width, double height) {
    Drawing drawing;
    drawing.width = width;
    drawing.height = height;
    return drawing;
}

// mm of the drawing become pixels of the truth; the middle of pixel (x, y) is at (x + 0.5, y + 0.5).
TEST(Lines, OfAStrokeAreOnePixelWideWhereItRuns) {
    Drawing drawing = sheet(20, 10);
    drawing.strokes.push_back({{{2.25, 3.25}, {6.25, 3.25}}});
    Pixels row;
    for (std::uint32_t x = 4; x <= 12; ++x) row.push_back(6 * 40 + x);
    EXPECT_EQ(all_of(drawing, 40, 20).pixels, row);
    drawing.strokes = {{{{-1, 9}, {30, 15}}}};  // beyond the edge it stays on it
    EXPECT_FALSE(all_of(drawing, 40, 20).pixels.empty());
}

TEST(Lines, AreClosedWhereTheStrokeIs) {
    constexpr std::size_t kRing = 56;  // four sides of 15, but for the corners, which thinning takes
    Drawing drawing = sheet(30, 30);
    drawing.strokes.push_back({{{5.5, 5.5}, {20.5, 5.5}, {20.5, 20.5}, {5.5, 20.5}}, true});
    EXPECT_EQ(all_of(drawing, 30, 30).pixels.size(), kRing);
    drawing.areas.push_back({{drawing.strokes[0].points}});
    drawing.strokes.clear();
    EXPECT_EQ(all_of(drawing, 30, 30).pixels.size(), kRing);
}

TEST(Lines, WithoutStrengthAreLeastAmongOthersAndElseAlwaysThere) {
    Drawing drawing = sheet(30, 30);
    drawing.strokes.push_back({{{5.5, 5.5}, {20.5, 5.5}}, false, LineClass::normal, 0});
    EXPECT_EQ(cut_at(lines_of(drawing, 30, 30), 200).pixels.size(), 16u);
    drawing.strokes.push_back({{{5.5, 15.5}, {20.5, 15.5}}, false, LineClass::normal, 40});
    EXPECT_EQ(cut_at(lines_of(drawing, 30, 30), 200).pixels.size(), 0u);
    EXPECT_EQ(cut_at(lines_of(drawing, 30, 30), 40).pixels.size(), 16u);
    EXPECT_EQ(cut_at(lines_of(drawing, 30, 30), 0).pixels.size(), 32u);
}

TEST(Lines, OfAPictureAreTheBordersOfItsRegions) {
    Image image = make_image(10, 8, 1, 1, 200);
    for (int y = 0; y < 8; ++y) std::fill(image.row(y) + 6, image.row(y) + 10, std::uint8_t{90});
    Pixels border;
    for (std::uint32_t y = 0; y < 8; ++y) border.push_back(y * 10 + 5);
    EXPECT_EQ(all_of(image, 10, 8).pixels, border);
    // Drawn under a drawing it is the same; a colour that alone differs is a border, too.
    Drawing drawing = sheet(10, 8);
    drawing.picture = image;
    EXPECT_EQ(all_of(drawing, 10, 8).pixels, border);
    Image colour = make_image(10, 8, 3, 1, 200);
    for (int y = 0; y < 8; ++y)
        for (int x = 6; x < 10; ++x) colour.row(y)[3 * x + 2] = 90;
    EXPECT_EQ(all_of(colour, 10, 8).pixels, border);
    EXPECT_TRUE(all_of(make_image(10, 8, 1, 1, 7), 10, 8).pixels.empty());
}

TEST(Lines, OfASmallerEdgeMapLieInTheMiddleOfItsPixels) {
    EdgeMap edges;
    edges.width = 10;
    edges.height = 8;
    edges.strength.assign(80, 0.0f);
    for (std::size_t y = 0; y < 8; ++y) edges.strength[y * 10 + 4] = 30;
    const PixelSet lines = all_of(edges, 30, 24);
    EXPECT_GE(lines.pixels.size(), 22u);
    for (const std::uint32_t pixel : lines.pixels) EXPECT_NEAR(pixel % 30, 13, 1);
    EXPECT_TRUE(cut_at(lines_of(edges, 30, 24), 31).pixels.empty());
    EXPECT_EQ(cut_at(lines_of(edges, 10, 8), 30).pixels.size(), 8u);
}

}  // namespace
}  // namespace tactics::lines_test
