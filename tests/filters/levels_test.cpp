// SPDX-License-Identifier: Apache-2.0
// Fields of colours as levels: lines where the values are, whatever the colours, and nothing of pictures without a scale.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "filters/choose.h"
#include "filters/colour_fields.h"
#include "filters/list.h"
#include "tests/near_strokes.h"

namespace tactics::levels_test {
namespace {

using tests::distance_to;

constexpr double kPixel = 0.5;  // mm
constexpr int kWidth = 500, kHeight = 360;
constexpr PixelBox kField{60, 40, 360, 320}, kBar{390, 40, 408, 320};

using Rgb = std::array<std::uint8_t, 3>;
using Scale = std::function<Rgb(double)>;
using Values = std::function<double(double, double)>;  // over a field from 0 to 1, y up

// Between the colours of the list, in equal steps.
Scale through(std::vector<Rgb> colours) {
    return [colours = std::move(colours)](double at) {
        const double place = std::clamp(at, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
        const std::size_t i = std::min(static_cast<std::size_t>(place), colours.size() - 2);
        Rgb colour;
        for (std::size_t c = 0; c < 3; ++c)
            colour[c] = static_cast<std::uint8_t>(
                std::lround(colours[i][c] + (place - static_cast<double>(i)) * (colours[i + 1][c] - colours[i][c])));
        return colour;
    };
}
const Scale kGrey = through({{0, 0, 0}, {255, 255, 255}});
const Scale kRainbow = through({{0, 0, 160}, {0, 120, 255}, {60, 240, 180}, {250, 220, 0}, {240, 40, 0}, {130, 0, 0}});
const Scale kLeaf = through({{70, 0, 90}, {50, 90, 140}, {40, 160, 130}, {250, 230, 40}});

void set(Image& image, int x, int y, const Rgb& colour) { std::copy(colour.begin(), colour.end(), image.row(y) + 3 * x); }

void frame_in(Image& image, const PixelBox& box) {
    for (int x = box.left - 1; x <= box.right; ++x) set(image, x, box.top - 1, {0, 0, 0}), set(image, x, box.bottom, {0, 0, 0});
    for (int y = box.top - 1; y <= box.bottom; ++y) set(image, box.left - 1, y, {0, 0, 0}), set(image, box.right, y, {0, 0, 0});
}

Image figure(const Values& value, const Scale& scale, bool with_bar = true) {
    Image image = make_image(kWidth, kHeight, 3, kPixel, 255);
    frame_in(image, kField);
    for (int y = kField.top; y < kField.bottom; ++y)
        for (int x = kField.left; x < kField.right; ++x)
            set(image, x, y, scale(value((x + 0.5 - kField.left) / kField.width(), (kField.bottom - y - 0.5) / kField.height())));
    if (!with_bar) return image;
    frame_in(image, kBar);
    for (int y = kBar.top; y < kBar.bottom; ++y)
        for (int x = kBar.left; x < kBar.right; ++x) set(image, x, y, scale((kBar.bottom - y - 0.5) / kBar.height()));
    return image;
}

double ramp(double x, double) { return x; }
double bump(double x, double y) { return std::exp(-((x - 0.45) * (x - 0.45) + (y - 0.5) * (y - 0.5)) / 0.1); }

Drawing levels_in(const Image& image, const std::string& settings = "") {
    const Step step = parse_step("levels " + settings, "test", filters());
    return std::get<Drawing>(step.filter->apply(image, step.settings));
}

// The lines between levels: all strokes well within the field.
std::vector<Stroke> level_lines(const Drawing& drawing) {
    std::vector<Stroke> lines;
    for (const Stroke& stroke : drawing.strokes) {
        const Point middle = stroke.points[stroke.points.size() / 2];
        if (middle.x > (kField.left + 5) * kPixel && middle.x < (kField.right - 5) * kPixel) lines.push_back(stroke);
    }
    return lines;
}

void expect_same_lines(const std::vector<Stroke>& a, const std::vector<Stroke>& b, double tolerance) {
    ASSERT_EQ(a.size(), b.size());
    for (const Stroke& line : a)
        for (const Point& p : line.points) EXPECT_LT(distance_to(b, p), tolerance) << p.x << ", " << p.y;
    for (const Stroke& line : b)
        for (const Point& p : line.points) EXPECT_LT(distance_to(a, p), tolerance) << p.x << ", " << p.y;
}

TEST(Levels, ARampIsCutAtEqualDistances) {
    const std::vector<Stroke> lines = level_lines(levels_in(figure(ramp, kGrey)));
    ASSERT_EQ(lines.size(), 3u);
    for (const double share : {0.25, 0.5, 0.75})
        for (const double y : {60.0, 100.0, 140.0})
            EXPECT_LT(distance_to(lines, {(kField.left + share * kField.width()) * kPixel, y}), 1) << share << ", " << y;
}

TEST(Levels, ABumpIsRingsWithinEachOtherAtItsHeights) {
    const std::vector<Stroke> lines = level_lines(levels_in(figure(bump, kLeaf)));
    ASSERT_EQ(lines.size(), 3u);
    std::vector<double> heights;
    for (const Stroke& line : lines) {
        EXPECT_TRUE(line.closed);
        double sum = 0;
        for (const Point& p : line.points)
            sum += bump((p.x / kPixel - kField.left) / kField.width(), (kField.bottom - p.y / kPixel) / kField.height());
        heights.push_back(sum / static_cast<double>(line.points.size()));
    }
    std::sort(heights.begin(), heights.end());
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(heights[static_cast<std::size_t>(k)], 0.25 * (k + 1), 0.04);
}

TEST(Levels, ColoursMakeNoDifference) {
    const std::vector<Stroke> grey = level_lines(levels_in(figure(bump, kGrey)));
    expect_same_lines(grey, level_lines(levels_in(figure(bump, kRainbow))), 2 * kPixel);
    expect_same_lines(grey, level_lines(levels_in(figure(bump, kLeaf))), 2 * kPixel);
}

TEST(Levels, TheMirroredFieldGivesTheMirroredLines) {
    std::vector<Stroke> mirrored = level_lines(levels_in(figure([](double x, double y) { return bump(1 - x, y); }, kLeaf)));
    for (Stroke& line : mirrored)
        for (Point& p : line.points) p.x = (kField.left + kField.right) * kPixel - p.x;
    expect_same_lines(level_lines(levels_in(figure(bump, kLeaf))), mirrored, kPixel);
}

TEST(Levels, TheBarHasTheTexturesOfTheField) {
    std::set<int> field, bar;
    for (const Area& area : levels_in(figure(ramp, kRainbow)).areas)
        (area.rings[0][0].x > (kField.right + 2) * kPixel ? bar : field).insert(area.texture);
    EXPECT_EQ(field.size(), 3u);  // the lowest level is blank
    EXPECT_EQ(field, bar);
    EXPECT_TRUE(levels_in(figure(ramp, kRainbow), "textures=no").areas.empty());
}

TEST(Levels, ACurveOnTheFieldStays) {
    Image image = figure(ramp, kLeaf);
    for (int x = kField.left + 20; x < kField.right - 20; ++x)
        for (int k = 0; k < 3; ++k) set(image, x, 180 + k, {255, 255, 255});
    const std::vector<Stroke> lines = level_lines(levels_in(image));
    for (int x = kField.left + 30; x < kField.right - 30; x += 5)
        EXPECT_LT(distance_to(lines, {x * kPixel, 181.5 * kPixel}), 1) << x;
}

TEST(Levels, WithoutAFieldTheLightnessIsDrawnInAFrame) {
    Image image = make_image(kWidth, kHeight, 3, kPixel, 240);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth / 2; ++x) set(image, x, y, {30, 30, 30});
    const Drawing drawing = levels_in(image);
    ASSERT_EQ(drawing.strokes.size(), 2u);
    EXPECT_TRUE(drawing.strokes[1].closed);
    ASSERT_FALSE(drawing.remarks.empty());
    EXPECT_NE(drawing.remarks[0].english().find("No field"), std::string::npos);
    EXPECT_TRUE(levels_in(make_image(kWidth, kHeight, 3, kPixel, 240)).strokes.empty());
}

TEST(ColourFields, AreChosenWithTheirBarAndWithoutOneIfTheyHaveHues) {
    for (const Scale& scale : {kGrey, kRainbow, kLeaf}) EXPECT_EQ(choose_recipe(figure(bump, scale)).recipe, "levels");
    Image alone = figure(bump, kLeaf, false);
    EXPECT_NE(choose_recipe(alone).recipe, "levels") << "a framed photograph of few hues";
    for (int number = 0; number < 5; ++number)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 6; ++x) set(alone, kField.left + 60 * number + x, kField.bottom + 14 + y, {0, 0, 0});
    EXPECT_EQ(choose_recipe(alone).recipe, "levels");
    EXPECT_NE(choose_recipe(figure(bump, kGrey, false)).recipe, "levels");
}

TEST(ColourFields, OtherPicturesInAFrameHaveNone) {
    // As many hues as a photograph, a map of plain colours, and one colour beside a bar.
    const Image shades = figure([](double x, double y) { return std::fmod(7.3 * x + 3.1 * y * y, 1.0); },
                                [](double at) {
                                    return Rgb{static_cast<std::uint8_t>(127 + 120 * std::sin(40 * at)),
                                               static_cast<std::uint8_t>(127 + 120 * std::sin(57 * at)),
                                               static_cast<std::uint8_t>(127 + 120 * std::sin(31 * at))};
                                },
                                false);
    EXPECT_TRUE(colour_fields_in(shades).empty());
    const Scale plain = [](double at) {
        constexpr Rgb kColours[] = {{220, 60, 60}, {60, 180, 75}, {250, 220, 50}, {0, 130, 200}};
        return kColours[std::min(3, static_cast<int>(4 * at))];
    };
    EXPECT_TRUE(colour_fields_in(figure(bump, plain, false)).empty());
    EXPECT_TRUE(colour_fields_in(figure([](double, double) { return 0.5; }, kLeaf)).empty());
    EXPECT_TRUE(colour_fields_in(make_image(kWidth, kHeight, 3, kPixel, 90)).empty());
}

}  // namespace
}  // namespace tactics::levels_test
