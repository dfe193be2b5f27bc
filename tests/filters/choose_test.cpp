// SPDX-License-Identifier: Apache-2.0
// Which recipe suits a picture: the samples, as drawn and as a scan or a camera gives them.
#include "filters/choose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "filters/traits.h"
#include "samples/draw/scenes.h"
#include "tests/filters/pictures.h"
#include "tests/tactics/readers/pictures.h"

namespace tactics::choose_test {
namespace {

constexpr int kLook = 500;  // what the program looks at

/// What paper, lens, lamp and file do to a picture.
struct Wear {
    const char* name;
    double grain;     // deviation of the noise that all channels share, in grey levels
    double speckle;   // and of each channel's own
    int blur;         // passes of 1 2 1, each a deviation of 0.7 pixels
    double corners;   // share of the light that is missing in the corners
    double side;      // and at the right border
    double paper[3];  // light that the paper gives back
};

constexpr Wear kWears[] = {
    {"compressed", 0, 0, 0, 0, 0, {1, 1, 1}},
    {"grain", 6, 0, 1, 0.15, 0, {1, 1, 1}},
    {"much grain", 10, 0, 1, 0.15, 0, {1, 1, 1}},
    {"speckle", 0, 8, 1, 0.15, 0.1, {1, 1, 1}},
    {"dim", 6, 2, 1, 0.2, 0.2, {0.7, 0.7, 0.7}},
    {"yellow paper", 6, 2, 2, 0.15, 0.1, {1, 0.93, 0.8}},
    {"lamp at one side", 8, 0, 1, 0.2, 0.25, {1, 1, 1}},
};

Image softened(Image image) {
    const auto pass = [&image](int dx, int dy) {
        const Image from = image;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    const auto at = [&](int side) {
                        const int column = std::clamp(x + side * dx, 0, image.width - 1),
                                  row = std::clamp(y + side * dy, 0, image.height - 1);
                        return static_cast<int>(from.row(row)[3 * column + c]);
                    };
                    image.row(y)[3 * x + c] = static_cast<std::uint8_t>((at(-1) + 2 * at(0) + at(1) + 2) / 4);
                }
    };
    pass(1, 0);
    pass(0, 1);
    return image;
}

Image lit(Image image, double corners, double side, const double (&paper)[3], double grain, double speckle) {
    pictures::Chance chance(1);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double u = 2.0 * x / image.width - 1, v = 2.0 * y / image.height - 1;
            const double light = 1 - corners * (u * u + v * v) / 2 - side * (u + 1) / 2, noise = grain * chance.normal();
            for (int c = 0; c < 3; ++c) {
                std::uint8_t& sample = image.row(y)[3 * x + c];
                const double level = sample * light * paper[c] + noise + speckle * chance.normal();
                sample = static_cast<std::uint8_t>(std::clamp(std::lround(level), 0L, 255L));
            }
        }
    return image;
}

Image worn(Image image, const Wear& wear) {
    for (int i = 0; i < wear.blur; ++i) image = softened(std::move(image));
    image = lit(std::move(image), wear.corners, wear.side, wear.paper, wear.grain, wear.speckle);
    JpegKind kind;
    kind.quality = 60;
    const Bytes file = jpeg_of(image, kind);
    Source source = memory_source(file, wear.name);
    return read_picture(source, {kLook, true});
}

std::string recipe_for(std::string_view scene) { return scene == "chart" ? "diagram" : std::string(scene); }

TEST(Choice, OfADrawingIsTheSameAfterAScan) {
    for (const char* scene : {"map", "chart", "line-art"})
        for (const int size : {400, 500, 900}) {
            const Image drawn = samples::draw_scene(scene, size);
            if (size <= kLook) {
                EXPECT_EQ(choose_recipe(drawn).recipe, recipe_for(scene)) << size;
            }
            for (const Wear& wear : kWears) {
                const Choice choice = choose_recipe(worn(drawn, wear));
                EXPECT_EQ(choice.recipe, recipe_for(scene)) << size << ", " << wear.name << ": " << choice.reason.english();
            }
        }
}

TEST(Choice, OfAPhotographIsPhoto) {
    for (const auto& scene : samples::scenes()) {
        if (!scene.photograph) continue;
        const Image taken = samples::draw_scene(scene.name, 300);
        EXPECT_EQ(choose_recipe(taken).recipe, "photo") << scene.name;
        EXPECT_EQ(choose_recipe(softened(softened(taken))).recipe, "photo") << scene.name << ", blurred";
        EXPECT_EQ(choose_recipe(to_grey(taken)).recipe, "photo") << scene.name << ", grey";
    }
}

// Grey bars are no lines, and a dark screen is a ground like a white one.
TEST(Choice, OfAChartIsDiagramInAnyColours) {
    Image chart = samples::draw_scene("chart", kLook);
    EXPECT_EQ(choose_recipe(to_grey(chart)).recipe, "diagram");
    for (std::uint8_t& sample : chart.pixels) sample = static_cast<std::uint8_t>(255 - sample);
    EXPECT_EQ(choose_recipe(chart).recipe, "diagram");
}

// The middle of a black disc says nothing; its outline does.
TEST(Choice, OfASilhouetteIsNotLineArt) {
    const auto disc = [](double radius) {
        return pictures::drawn(kLook, 400, [=](int x, int y) { return std::hypot(x - 250, y - 200) < radius ? 20 : 250; });
    };
    EXPECT_EQ(choose_recipe(disc(100)).recipe, "diagram");
    const auto ring =
        pictures::drawn(kLook, 400, [](int x, int y) { return std::abs(std::hypot(x - 250, y - 200) - 100) < 4 ? 20 : 250; });
    EXPECT_EQ(choose_recipe(ring).recipe, "line-art");
}

Image toned(Image image, double times, double plus) {
    for (std::uint8_t& sample : image.pixels) sample = static_cast<std::uint8_t>(std::lround(sample * times + plus));
    return image;
}

// A dark photograph has few greys, as a drawing has.
TEST(Choice, OfADarkOrFaintPhotographIsPhoto) {
    for (const auto& scene : samples::scenes()) {
        if (!scene.photograph) continue;
        const Image taken = samples::draw_scene(scene.name, 300);
        EXPECT_EQ(choose_recipe(toned(taken, 0.1, 0)).recipe, "photo") << scene.name << ", dark";
        EXPECT_EQ(choose_recipe(toned(taken, 0.2, 102)).recipe, "photo") << scene.name << ", faint";
    }
}

// However little ink there is, the page is white and not faint.
TEST(Choice, OfAPageWithALittleInkIsThatOfAPage) {
    const auto dot = [](int ground, double noise) {
        std::mt19937 random(3);
        return pictures::drawn(640, 480, [=](int x, int y) mutable {
            return std::hypot(x - 300, y - 200) < 15
                       ? 0
                       : ground + static_cast<int>(noise * (static_cast<double>(random() % 100) / 50 - 1));
        });
    };
    EXPECT_EQ(choose_recipe(dot(255, 0)).recipe, "line-art");
    EXPECT_EQ(choose_recipe(dot(200, 7)).recipe, "line-art");
}

// Twenty colours are more than a drawing's eight, but each is plain; a photograph's shades are not.
TEST(Choice, OfManyPlainColoursIsNotPhoto) {
    const Image table = pictures::drawn(640, 480, [](int x, int y) {
        if (x < 130 || x >= 510 || y < 60 || y >= 420) return 255;
        return 20 + 11 * ((x - 130) / 76 + 5 * ((y - 60) / 90));
    });
    EXPECT_LT(traits_of(table).few, 0.845);
    EXPECT_NE(choose_recipe(table).recipe, "photo");
    const Image shaded = pictures::drawn(640, 480, [](int x, int y) { return (x * 7 + y * 11) / 45; });
    EXPECT_EQ(choose_recipe(shaded).recipe, "photo");
}

Image coloured(int width, int height, const std::function<std::array<double, 3>(double, double)>& at) {
    Image image = make_image(width, height, 3, 0, 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                image.row(y)[3 * x + c] =
                    static_cast<std::uint8_t>(std::clamp(std::lround(at(x, y)[static_cast<std::size_t>(c)]), 0L, 255L));
    return image;
}

// A grey curve goes with one cut between ink and paper; the grid, as pale, may.
TEST(Choice, OfPaleLinesBesideDarkOnesIsDiagram) {
    const auto chart = [](bool curve) {
        return pictures::drawn(kLook, 360, [curve](int x, int y) {
            const auto from_curve = [&](double high) { return std::abs(y - 180 - high * std::sin(x / 25.0)); };
            if (std::abs(x - 60) < 2 || std::abs(y - 310) < 2 || from_curve(40) < 2) return 40;
            if (curve && from_curve(90) < 2) return 185;
            return x % 80 < 2 || y % 80 < 2 ? 185 : 255;
        });
    };
    EXPECT_EQ(choose_recipe(chart(true)).recipe, "diagram");
    EXPECT_EQ(choose_recipe(chart(false)).recipe, "line-art");
}

// No recipe for ink draws a box in a pale colour, small as it is.
TEST(Choice, OfAGraphWithAPaintedBoxIsDiagram) {
    const auto graph = [](int inside) {
        return pictures::drawn(kLook, 360, [inside](int x, int y) {
            const auto box = [&](int left, int top) {
                if (x < left || y < top || x >= left + 60 || y >= top + 40) return -1;
                return x < left + 4 || y < top + 4 || x >= left + 56 || y >= top + 36 ? 0 : 1;
            };
            if (box(100, 60) == 0 || box(300, 240) == 0 || (x >= 160 && x < 300 && std::abs(x - y - 70) < 4)) return 20;
            return box(300, 240) == 1 ? inside : 255;
        });
    };
    EXPECT_EQ(choose_recipe(graph(255)).recipe, "line-art");
    EXPECT_EQ(choose_recipe(graph(215)).recipe, "diagram");
}

// As plots of logarithms have: hardly any place is plain, or an edge.
TEST(Choice, OfADenseGridIsDiagram) {
    const Image chart = pictures::drawn(kLook, 360, [](int x, int y) {
        if (x < 60 || x >= 460 || y < 40 || y >= 310) return 255;
        if (x == 60 || y == 309 || std::abs(y - 300 + 0.6 * (x - 60)) < 1.5) return 0;
        const int near = std::min(x % 7, y % 5);
        return near == 0 ? 176 : near == 1 ? 215 : 255;
    });
    const Choice choice = choose_recipe(chart);
    EXPECT_EQ(choice.recipe, "diagram") << choice.reason.english();
    EXPECT_GT(traits_of(chart).soft, 0.4);
}

// Bars with a hatch whose lines are a bit farther apart than whole pixels, and so of many greys.
TEST(Choice, OfHatchedBarsOnWhiteIsDiagram) {
    const auto covered = [](double at, double width) {  // of a pixel, by lines of that pitch
        constexpr double kPitch = 6.94;
        const double off = std::fmod(at + 100 * kPitch, kPitch);
        return std::clamp(std::min(off + 1, width) - std::max(off, 0.0), 0.0, 1.0) +
               std::clamp(std::min(off + 1 - kPitch, width), 0.0, 1.0);
    };
    const Image picture = pictures::drawn(600, 450, [&](int x, int y) {
        const int bar = (x - 80) / 100, within = (x - 80) % 100;
        if (x < 80 || bar > 4 || within > 64 || y > 400 || y < 90 + 40 * ((bar * 3) % 5)) return 255.0;
        if (within == 0 || within == 64 || y == 400) return 0.0;
        return 255 * (1 - std::min(1.0, covered(x, 1.4) + covered(y, 1.4)));
    });
    EXPECT_EQ(choose_recipe(picture).recipe, "diagram");
}

// Half of it is the panel's grey, and the lines of its grid are hardly lighter.
TEST(Choice, OfAChartOnAPanelIsDiagram) {
    const Image chart = coloured(kLook, 360, [](double x, double y) -> std::array<double, 3> {
        if (x < 60 || x >= 460 || y < 40 || y >= 310) return {255, 255, 255};
        if (std::abs(y - 180 - 90 * std::sin(x / 40)) < 3) return {175, 165, 165};
        const double level = std::fmod(x - 60, 80) < 4 || std::fmod(y - 40, 80) < 4 ? 245 : 229;
        return {level, level, level};
    });
    const Choice choice = choose_recipe(softened(chart));
    EXPECT_EQ(choice.recipe, "diagram") << choice.reason.english();
}

// Smooth hills and valleys of all sizes, -1 to 1: fur, cloud, foliage.
double mottle(double x, double y) {
    double sum = 0, height = 0.5;
    for (double wave = 90; wave > 3; wave /= 2, height *= 0.62)
        sum += height * std::sin(x / wave * 3 + 5 * std::sin(y / wave)) * std::cos(y / wave * 2.6 + 3 * std::sin(x / wave * 1.3));
    return sum;
}

// Black and white, and no ink: its stripes are fur, and what is behind it is out of focus.
TEST(Choice, OfAZebraIsPhoto) {
    pictures::Chance chance(7);
    const Image zebra = pictures::drawn(480, 320, [&](int x, int y) {
        const bool body = std::hypot((x - 240) / 190.0, (y - 160) / 120.0) < 1;
        const double stripe = 1 / (1 + std::exp(-6 * std::sin(x / 11.0 + 1.5 * mottle(y, x / 3.0))));
        const double grass = 150 + 40 * mottle(x / 3.0, y / 3.0);
        return (body ? 35 + 170 * stripe + 24 * mottle(4.0 * x, 4.0 * y) : grass) + 3 * chance.normal();
    });
    EXPECT_EQ(choose_recipe(zebra).recipe, "photo") << choose_recipe(zebra).reason.english();
    EXPECT_EQ(choose_recipe(toned(zebra, 0.1, 0)).recipe, "photo") << "dark";
}

// A lens blurs the border of what is black, and the sky behind it has shades.
TEST(Choice, OfASilhouetteAtDuskIsPhoto) {
    pictures::Chance chance(8);
    const Image dusk = softened(softened(coloured(480, 320, [&](double x, double y) -> std::array<double, 3> {
        const double hill = 230 + 25 * std::sin(x / 70) + 12 * mottle(3 * x, 0), noise = 1.5 * chance.normal();
        const bool tree = std::hypot(x - 150 + 9 * mottle(2 * y, x), y - 190 + 9 * mottle(2 * x, y)) < 60;
        if (y > hill || tree) return {14 + noise, 10 + noise, 16 + noise};
        const double cloud = 18 * mottle(x / 2, 2 * y);
        return {90 + 0.6 * y + cloud + noise, 60 + 0.3 * y + cloud + noise, 110 - 0.2 * y + cloud + noise};
    })));
    EXPECT_EQ(choose_recipe(dusk).recipe, "photo") << choose_recipe(dusk).reason.english();
}

TEST(Choice, OfFogIsPhoto) {
    pictures::Chance chance(9);
    const Image fog = pictures::drawn(480, 320, [&](int x, int y) {
        double level = 205 - 0.05 * y;
        for (int row = 0; row < 4; ++row)
            if (y > 90 + 55 * row + 30 * mottle(x + 170.0 * row, 9.0 * row))
                level = 195 - 14 * row + 6 * mottle(2.0 * x, 2.0 * y + 50 * row);
        return level + chance.normal();
    });
    EXPECT_EQ(choose_recipe(fog).recipe, "photo") << choose_recipe(fog).reason.english();
}

double cover(double distance) { return std::clamp(0.5 - distance, 0.0, 1.0); }  // of a pixel with its middle so far outside

// Nothing of it is as fine as the blur of its borders.
TEST(Choice, OfASmallFlatIconIsDiagram) {
    for (const double size : {32.0, 48.0, 64.0, 256.0}) {
        const Image icon = coloured(static_cast<int>(size), static_cast<int>(size), [&](double x, double y) {
            std::array<double, 3> colour{255, 255, 255};
            const auto lay = [&](double part, std::array<double, 3> over) {
                for (std::size_t c = 0; c < 3; ++c) colour[c] += part * (over[c] - colour[c]);
            };
            const double u = x + 0.5 - size / 2, v = y + 0.5 - size / 2;
            lay(cover(std::hypot(u, v) - 0.44 * size), {230, 90, 60});
            lay(cover(std::max(std::abs(u) - 0.22 * size, std::abs(v + 0.08 * size) - 0.12 * size)), {250, 220, 90});
            lay(cover(std::hypot(u, v - 0.2 * size) - 0.11 * size), {60, 80, 160});
            return colour;
        });
        EXPECT_EQ(choose_recipe(icon).recipe, "diagram") << size << ": " << choose_recipe(icon).reason.english();
    }
}

TEST(Choice, OfAChartOnDarkGroundIsDiagram) {
    const Image chart = coloured(480, 360, [](double x, double y) -> std::array<double, 3> {
        if ((std::abs(x - 50) < 1 && y > 30 && y < 320) || (std::abs(y - 320) < 1 && x > 50 && x < 450)) return {210, 210, 215};
        if (std::fmod(y, 58) < 1 && x > 50 && x < 450 && y < 320) return {58, 62, 70};
        if (std::abs(y - 190 + 80 * std::sin(x / 50)) < 2 && x > 50 && x < 450) return {240, 160, 40};
        if (y < 320 && y > 330 - 28 * std::floor(x / 50) && std::fmod(x, 50) > 20 && x > 50 && x < 450) return {70, 150, 220};
        return {30, 33, 40};
    });
    EXPECT_EQ(choose_recipe(chart).recipe, "diagram") << choose_recipe(chart).reason.english();
    EXPECT_EQ(choose_recipe(to_grey(chart)).recipe, "diagram") << "grey";
}

TEST(Choice, OfAGrainyGreyScanIsThatOfTheDrawing) {
    for (const char* scene : {"chart", "line-art"}) {
        const Image scan = to_grey(worn(samples::draw_scene(scene, kLook), {"grey", 8, 0, 1, 0.15, 0.15, {0.85, 0.85, 0.85}}));
        EXPECT_EQ(choose_recipe(scan).recipe, recipe_for(scene)) << choose_recipe(scan).reason.english();
    }
}

// What surrounds a picture is not of it.
TEST(Choice, IsThatOfThePictureInAFrame) {
    for (const char* scene : {"balloon", "house", "map"}) {
        const Image picture = samples::draw_scene(scene, kLook);
        const Traits bare = traits_of(picture);
        for (const std::uint8_t level : {std::uint8_t{0}, std::uint8_t{255}}) {
            const int bar = 70;
            Image image = make_image(picture.width + 2 * bar, picture.height + 2 * bar, 3, 0, level);
            for (int y = 0; y < picture.height; ++y)
                std::copy_n(picture.row(y), picture.row_bytes(), image.row(y + bar) + static_cast<std::ptrdiff_t>(3) * bar);
            const Traits within = traits_of(image);
            EXPECT_EQ(choose_recipe(image).recipe, choose_recipe(picture).recipe) << scene;
            EXPECT_NEAR(within.flat, bare.flat, 0.02) << scene;
            EXPECT_NEAR(within.soft, bare.soft, 0.02) << scene;
        }
    }
}

TEST(Choice, DoesNotSeeTheLamp) {
    for (const char* scene : {"map", "chart"}) {
        const Image drawn = samples::draw_scene(scene, kLook);
        const Traits even = traits_of(drawn), uneven = traits_of(lit(drawn, 0.2, 0.2, {1, 1, 1}, 0, 0));
        EXPECT_NEAR(uneven.few, even.few, 0.04) << scene;
        EXPECT_NEAR(uneven.flat, even.flat, 0.04) << scene;
        EXPECT_NEAR(uneven.ground, even.ground, 0.08) << scene;
        EXPECT_NEAR(uneven.colourful, even.colourful, 0.04) << scene;
    }
}

TEST(Choice, IsMadeForAnyShape) {
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(1, 700), std::pair(700, 1), std::pair(2, 3), std::pair(501, 3), std::pair(5, 5)})
        for (const int channels : {1, 3})
            for (const std::uint8_t level : {std::uint8_t{0}, std::uint8_t{140}, std::uint8_t{255}}) {
                const Traits traits = traits_of(make_image(width, height, channels, 0, level));
                EXPECT_EQ(traits.flat, 1);
                EXPECT_EQ(traits.few, 1);
                EXPECT_EQ(traits.ground, 1);
                EXPECT_EQ(traits.thick, 0);
            }
}

}  // namespace
}  // namespace tactics::choose_test
