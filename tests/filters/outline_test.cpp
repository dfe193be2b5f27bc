// SPDX-License-Identifier: Apache-2.0
#include "filters/outline.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/filters/shapes.h"

namespace tactics::outline_test {
namespace {

double area_of(const std::vector<Point>& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2;
}

double area_of(const Drawing& drawing) {
    double sum = 0;
    for (const Area& area : drawing.areas)
        for (std::size_t i = 0; i < area.rings.size(); ++i) sum += (i == 0 ? 1 : -1) * area_of(area.rings[i]);
    return sum;
}

double ink_of_picture(const Image& image) { return static_cast<double>(std::count(image.pixels.begin(), image.pixels.end(), 0)); }

// Rings along the pixel edges, as they are before smoothing, give the picture back pixel by pixel.
TEST(Outline, EnclosesExactlyTheInk) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const Image image = shapes::random_picture(1 + static_cast<int>(seed % 9) * 4, 23, seed, 5 + seed % 10 * 10);
        const auto outlines = outlines_of(ink_of(image));
        double enclosed = 0;
        std::vector<Area> areas;
        for (const Outline& outline : outlines) {
            areas.emplace_back();
            for (std::size_t i = 0; i < outline.rings.size(); ++i) {
                enclosed += (i == 0 ? 1 : -1) * outline.rings[i].area;
                areas.back().rings.push_back(outline.rings[i].points);
            }
        }
        EXPECT_DOUBLE_EQ(enclosed, ink_of_picture(image));
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                int covers = 0;
                for (const Area& area : areas) covers += shapes::inside(area, {x + 0.5, y + 0.5}) ? 1 : 0;
                ASSERT_EQ(covers, image.row(y)[x] == 0 ? 1 : 0) << seed << ": " << x << " " << y;
            }
    }
}

TEST(Outline, AreasAreTheInkWithSmoothBorders) {
    Image image = shapes::blank(240, 200);
    shapes::disc(image, {70, 70}, 50);
    shapes::fill(image, [](Point p) { return p.x > 140 && p.x < 225 && p.y > 30 && p.y < 150; });
    for (auto& [centre, radius] : {std::pair{Point{60, 75}, 20.0}, {Point{180, 80}, 22.0}})
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 240; ++x)
                if (std::hypot(x + 0.5 - centre.x, y + 0.5 - centre.y) < radius) image.row(y)[x] = 255;
    shapes::disc(image, {180, 80}, 9);  // an island
    const auto drawing = shapes::drawn("trace method=areas", image);
    ASSERT_EQ(drawing.areas.size(), 3u);
    EXPECT_TRUE(drawing.strokes.empty());
    EXPECT_NEAR(area_of(drawing), ink_of_picture(image), 0.01 * ink_of_picture(image));
    // Each pixel whose eight neighbours are like it is as it was.
    for (int y = 1; y < 199; ++y)
        for (int x = 1; x < 239; ++x) {
            bool border = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) border = border || image.row(y + dy)[x + dx] != image.row(y)[x];
            if (border) continue;
            int covers = 0;
            for (const Area& area : drawing.areas) covers += shapes::inside(area, {x + 0.5, y + 0.5}) ? 1 : 0;
            ASSERT_EQ(covers, image.row(y)[x] == 0 ? 1 : 0) << x << " " << y;
        }
    for (const Point& p : drawing.areas[0].rings[0]) EXPECT_NEAR(std::hypot(p.x - 70, p.y - 70), 50, 0.35);
    // The corners of the rectangle are there.
    for (const Point corner : {Point{140, 30}, {225, 30}, {225, 150}, {140, 150}}) {
        double least = 1e9;
        for (const Point& p : drawing.areas[1].rings[0]) least = std::min(least, std::hypot(p.x - corner.x, p.y - corner.y));
        EXPECT_LT(least, 0.75);
    }
}

TEST(Outline, KeepsTheAreaOfSmallAndThinRegions) {
    for (const double size : {6.0, 10.0, 25.0})
        for (int degrees = 0; degrees < 180; degrees += 20) {
            Image image = shapes::blank(120, 120);
            const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
            shapes::bar(image, {60 - size * c, 60 - size * s}, {60 + size * c, 60 + size * s}, 5);
            EXPECT_NEAR(area_of(shapes::drawn("trace method=areas", image)), ink_of_picture(image), 0.01 * ink_of_picture(image));
        }
}

TEST(Outline, TinyRegionsAreLeftOutAndTinyHolesFilled) {
    Image image = shapes::blank(100, 100);
    shapes::disc(image, {40, 40}, 30);
    image.row(40)[40] = 255;
    image.row(90)[90] = 0;
    const auto drawing = shapes::drawn("trace method=areas shortest=3", image);
    ASSERT_EQ(drawing.areas.size(), 1u);
    EXPECT_EQ(drawing.areas[0].rings.size(), 1u);
    EXPECT_EQ(shapes::drawn("trace method=areas shortest=0", image).areas.size(), 2u);
}

}  // namespace
}  // namespace tactics::outline_test
