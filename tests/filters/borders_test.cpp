// SPDX-License-Identifier: Apache-2.0
// Borders of plain colours: each drawn whole, where the colours meet, whatever line, letter or compression is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "filters/choose.h"
#include "filters/flat_regions.h"
#include "filters/list.h"
#include "tests/near_strokes.h"
#include "tests/tactics/readers/pictures.h"

namespace tactics::borders_test {
namespace {

using tests::distance_to;

constexpr double kPixel = 0.25;  // mm
constexpr int kWidth = 640, kHeight = 480;

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kBlack{0, 0, 0}, kGrey{200, 200, 200};

struct Province {
    double x, y;
    Colour colour;
};

// Twelve provinces of six colours; each pixel belongs to the nearest middle.
std::vector<Province> provinces() {
    constexpr Colour kColours[] = {{220, 60, 60}, {60, 180, 75}, {250, 220, 50}, {0, 130, 200}, {245, 130, 48}, {145, 30, 180}};
    std::vector<Province> all;
    for (int i = 0; i < 12; ++i)
        all.push_back({80.0 + i % 4 * 160 + 37 * std::sin(5.0 * i), 80.0 + i / 4 * 160 + 41 * std::cos(3.0 * i),
                       kColours[static_cast<std::size_t>(i * 5 % 6)]});
    return all;
}

struct TwoNearest {
    std::size_t first = 0;
    double edge = 0;  // pixels to the border with the second
};
TwoNearest nearest(const std::vector<Province>& all, double x, double y) {
    std::size_t first = 0;
    const auto away = [&](std::size_t i) { return std::hypot(all[i].x - x, all[i].y - y); };
    for (std::size_t i = 1; i < all.size(); ++i)
        if (away(i) < away(first)) first = i;
    double edge = 1e9;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i != first) {
            const double between = std::hypot(all[i].x - all[first].x, all[i].y - all[first].y);
            edge = std::min(edge, (away(i) * away(i) - away(first) * away(first)) / (2 * between));
        }
    return {first, edge};
}

template <typename ColourAt>
Image painted(const ColourAt& colour_at) {
    Image image = make_image(kWidth, kHeight, 3, kPixel, 0);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Colour colour = colour_at(x, y);
            std::copy(colour.begin(), colour.end(), image.row(y) + 3 * x);
        }
    return image;
}

Image map_with_outlines(double half_width) {
    return painted([all = provinces(), half_width](int x, int y) {
        const TwoNearest at = nearest(all, x + 0.5, y + 0.5);
        return at.edge < half_width ? kBlack : all[at.first].colour;
    });
}

Drawing drawn(const Image& image, const std::string& settings = "") {
    const Step step = parse_step("borders " + settings, "test", filters());
    return std::get<Drawing>(step.filter->apply(image, step.settings));
}

// The borders by the provinces themselves: all of them are drawn, and nothing else is.
void expect_all_borders(const Drawing& drawing, double tolerance) {
    const std::vector<Province> all = provinces();
    for (int y = 8; y < kHeight - 8; y += 3)
        for (int x = 8; x < kWidth - 8; x += 3)
            if (nearest(all, x, y).edge < 0.5) {
                EXPECT_LT(distance_to(drawing.strokes, {x * kPixel, y * kPixel}), tolerance) << x << ", " << y;
            }
    for (const Stroke& stroke : drawing.strokes)
        for (const Point& p : stroke.points)
            EXPECT_LT(nearest(all, p.x / kPixel, p.y / kPixel).edge * kPixel, tolerance) << p.x << ", " << p.y;
}

TEST(Borders, EachIsDrawnWholeWithAnOutlineOrWithout) {
    for (const double half_width : {0.0, 0.8, 2.0, 4.0}) {
        SCOPED_TRACE(half_width);
        const Drawing drawing = drawn(map_with_outlines(half_width));
        expect_all_borders(drawing, 0.75);
        EXPECT_TRUE(drawing.areas.empty());
    }
}

TEST(Borders, ThoseThatMeetMeetInOnePoint) {
    const Drawing drawing = drawn(map_with_outlines(1));
    std::size_t met = 0;
    for (const Stroke& stroke : drawing.strokes) {
        if (stroke.closed) continue;
        for (const Point& end : {stroke.points.front(), stroke.points.back()}) {
            const bool at_frame = end.x < 1 || end.y < 1 || end.x > kWidth * kPixel - 1 || end.y > kHeight * kPixel - 1;
            const auto sharing = std::count_if(drawing.strokes.begin(), drawing.strokes.end(), [&](const Stroke& other) {
                return other.points.front().x == end.x && other.points.front().y == end.y
                           ? true
                           : other.points.back().x == end.x && other.points.back().y == end.y;
            });
            EXPECT_TRUE(at_frame || sharing >= 3) << end.x << ", " << end.y;
            met += sharing >= 3 ? 1 : 0;
        }
    }
    EXPECT_GT(met, 10u);
}

TEST(Borders, CompressionCutsNoRegion) {
    for (const int quality : {50, 75, 90}) {
        SCOPED_TRACE(quality);
        JpegKind kind;
        kind.quality = quality;
        const Bytes file = jpeg_of(map_with_outlines(1), kind);
        Source source = memory_source(file, "map.jpg");
        Image image = read_picture(source, {kWidth, true});
        image.mm_per_pixel = kPixel;
        expect_all_borders(drawn(image), 1.25);
    }
}

TEST(Borders, ALineBetweenTwoRegionsOfOneColourIsABorder) {
    const Drawing drawing = drawn(painted([](int x, int) { return x == 300 ? kBlack : kGrey; }));
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_NEAR(length_of(drawing.strokes[0]), kHeight * kPixel, 1);
    EXPECT_NEAR(drawing.strokes[0].points[0].x, 300.5 * kPixel, 0.3);
}

TEST(Borders, ALineWithinARegionStaysAndLettersDoNot) {
    const auto river = [](int x, int y) { return std::abs(y - 240 - 40 * std::sin(x / 60.0)) < 1.5 && x > 60 && x < 500; };
    const auto letters = [](int x, int y) {
        return y > 60 && y < 84 && x > 100 && x < 260 && x % 24 < 14 && (x % 24 < 3 || y % 21 < 3);
    };
    const Drawing drawing = drawn(painted([&](int x, int y) { return river(x, y) || letters(x, y) ? kBlack : kGrey; }));
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_NEAR(drawing.strokes[0].points.front().x, 60 * kPixel, 1);
    EXPECT_NEAR(drawing.strokes[0].points.back().x, 500 * kPixel, 1);
}

TEST(Borders, ASmallIslandIsASpotAndATinyOneIsNothing) {
    const auto in = [](int x, int y, double cx, double cy, double r) { return std::hypot(x + 0.5 - cx, y + 0.5 - cy) < r; };
    const Drawing drawing = drawn(painted([&](int x, int y) -> Colour {
        return in(x, y, 200, 240, 6) || in(x, y, 300, 240, 1.5) || in(x, y, 460, 240, 60) ? Colour{60, 180, 75} : kGrey;
    }));
    ASSERT_EQ(drawing.areas.size(), 1u);
    EXPECT_NEAR(drawing.areas[0].rings[0][0].x, 200 * kPixel, 2.5);
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_TRUE(drawing.strokes[0].closed);
    EXPECT_NEAR(length_of(drawing.strokes[0]), 2 * 3.14159 * 60 * kPixel, 3);
}

TEST(Borders, ARegionTooNarrowForTheMediumJoinsANeighbourAndIsTold) {
    const Image image = painted([](int x, int y) -> Colour {
        return x >= 300 && x < 312 && y > 100 && y < 160 ? Colour{60, 180, 75} : x < 300 ? Colour{220, 60, 60} : kGrey;
    });
    const Drawing narrow = drawn(image), fine = drawn(image, "smallest=2mm");
    EXPECT_EQ(narrow.remarks.size(), 1u);
    EXPECT_EQ(narrow.strokes.size(), 1u);
    EXPECT_TRUE(fine.remarks.empty());
    EXPECT_EQ(fine.strokes.size(), 4u);
}

TEST(Borders, AStreetBetweenTwoRegionsIsOneLine) {
    const Drawing drawing = drawn(painted([](int x, int) {
        return x >= 300 && x < 312 ? Colour{250, 220, 50} : x < 300 ? Colour{220, 60, 60} : kGrey;
    }));
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_NEAR(drawing.strokes[0].points[0].x, 306 * kPixel, 0.5);
}

TEST(Borders, APictureWithoutPlainColoursHasNone) {
    Image image = make_image(kWidth, kHeight, 3, kPixel, 0);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::uint8_t>((i * 2654435761u) >> 13);
    EXPECT_TRUE(drawn(image).strokes.empty());
    EXPECT_FALSE(is_coloured_map(map_traits_of(image)));
}

Image crooked_map(double half_width) {
    return painted([all = provinces(), half_width](int x, int y) {
        const TwoNearest at = nearest(all, x + 9 * std::sin(y / 7.0), y + 9 * std::sin(x / 6.0));
        return at.edge < half_width ? kBlack : all[at.first].colour;
    });
}

TEST(MapTraits, ChooseTheRecipe) {
    EXPECT_EQ(choose_recipe(crooked_map(1)).recipe, "borders");
    EXPECT_NE(choose_recipe(map_with_outlines(1)).recipe, "borders");
}

TEST(MapTraits, TellAMapFromAChart) {
    EXPECT_TRUE(is_coloured_map(map_traits_of(crooked_map(1))));
    EXPECT_TRUE(is_coloured_map(map_traits_of(crooked_map(0))));
    EXPECT_FALSE(is_coloured_map(map_traits_of(map_with_outlines(1))));  // all straight, as a mosaic's
    const auto bars = painted([](int x, int y) -> Colour {
        if (x == 60 || y == 420) return kBlack;
        const int bar = (x - 80) / 80, top = 60 + bar * 47 % 200;
        return x >= 80 && (x - 80) % 80 < 50 && y > top && y < 420 ? provinces()[static_cast<std::size_t>(bar)].colour
                                                                   : Colour{255, 255, 255};
    });
    EXPECT_FALSE(is_coloured_map(map_traits_of(bars)));
    const Image one_colour = painted([](int, int) { return kGrey; });
    EXPECT_FALSE(is_coloured_map(map_traits_of(one_colour)));
}

}  // namespace
}  // namespace tactics::borders_test
