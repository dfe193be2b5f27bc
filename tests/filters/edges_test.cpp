// SPDX-License-Identifier: Apache-2.0
// Sobel, Canny and contours: required results for steps, planes, noise and colour, regardless of their implementation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "filters/edge_map.h"
#include "filters/edge_noise.h"
#include "filters/gradient.h"
#include "filters/list.h"

namespace tactics::edges_test {
namespace {

constexpr double kMm = 0.5;

Image step_picture(int size, double angle, int dark, int bright) {
    Image image = make_image(size, size, 1, kMm, 0);
    const double c = std::cos(angle), s = std::sin(angle), middle = (size - 1) / 2.0 + 0.2;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            // One pixel of transition: what a lens does, and what keeps slanted edges from being stairs.
            const double across = std::clamp((x - middle) * c + (y - middle) * s + 0.5, 0.0, 1.0);
            image.row(y)[x] = static_cast<std::uint8_t>(std::lround(dark + across * (bright - dark)));
        }
    return image;
}

Image noisy(Image image, double deviation, unsigned seed) {
    std::mt19937 random(seed);
    const auto unit = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
    for (auto& sample : image.pixels) {
        const double normal = std::sqrt(-2 * std::log(unit())) * std::cos(2 * std::numbers::pi * unit());
        sample = static_cast<std::uint8_t>(std::clamp(std::lround(sample + deviation * normal), 0L, 255L));
    }
    return image;
}

EdgeMap edges_of(const Image& image, const char* step) {
    const Recipe recipe = parse_recipe(step, "test", filters());
    return std::get<EdgeMap>(run(recipe, image));
}

float strongest(const EdgeMap& edges) { return *std::max_element(edges.strength.begin(), edges.strength.end()); }
double ink(const EdgeMap& edges) {
    const auto drawn = std::count_if(edges.strength.begin(), edges.strength.end(), [](float s) { return s > 0; });
    return static_cast<double>(drawn) / static_cast<double>(edges.strength.size());
}

TEST(Sobel, IsTheTextbookKernelWithoutBlur) {
    Image image = noisy(make_image(23, 17, 1, kMm, 128), 50, 7);
    const EdgeMap edges = edges_of(image, "sobel blur=0");
    const auto at = [&](int x, int y) { return static_cast<double>(image.row(std::clamp(y, 0, 16))[std::clamp(x, 0, 22)]); };
    for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 23; ++x) {
            const double gx =
                at(x + 1, y - 1) + 2 * at(x + 1, y) + at(x + 1, y + 1) - at(x - 1, y - 1) - 2 * at(x - 1, y) - at(x - 1, y + 1);
            const double gy =
                at(x - 1, y + 1) + 2 * at(x, y + 1) + at(x + 1, y + 1) - at(x - 1, y - 1) - 2 * at(x, y - 1) - at(x + 1, y - 1);
            ASSERT_NEAR(edges.strength[static_cast<std::size_t>(y * 23 + x)], std::hypot(gx, gy) / 4, 1e-3) << x << "," << y;
        }
}

TEST(Edges, StrengthIsTheHeightOfTheStepWhateverTheBlur) {
    for (const int height : {4, 40, 200})
        for (const char* filter :
             {"sobel blur=0.5mm", "sobel blur=2mm", "canny blur=1mm low=0 high=0", "canny blur=3mm low=0 high=0"})
            EXPECT_NEAR(strongest(edges_of(step_picture(64, 0, 20, 20 + height), filter)), height, 0.08 * height + 0.2) << filter;
}

TEST(Edges, StrengthDoesNotDependOnTheDirection) {
    for (int degrees = 0; degrees < 180; degrees += 15) {
        const Image image = step_picture(96, degrees * std::numbers::pi / 180, 60, 160);
        EXPECT_NEAR(strongest(edges_of(image, "sobel blur=1mm")), 100, 8) << degrees;
        EXPECT_NEAR(strongest(edges_of(image, "contours surround=0")), 100, 12) << degrees;
    }
}

TEST(Edges, AStraightStepGivesOneThinLineWhereItIs) {
    for (const char* filter : {"sobel thin=yes", "canny", "contours"})
        for (int degrees = 0; degrees < 180; degrees += 20) {
            const double angle = degrees * std::numbers::pi / 180;
            const EdgeMap edges = edges_of(step_picture(96, angle, 60, 160), filter);
            EXPECT_TRUE(edges.thinned);
            int drawn = 0;
            for (int y = 12; y < 84; ++y)
                for (int x = 12; x < 84; ++x)
                    if (edges.strength[static_cast<std::size_t>(y * 96 + x)] > 20) {
                        ++drawn;
                        const double away = (x - 47.7) * std::cos(angle) + (y - 47.7) * std::sin(angle);
                        EXPECT_LE(std::abs(away), 1.2) << filter << " " << degrees;
                    }
            EXPECT_GE(drawn, 70) << filter << " " << degrees;
            EXPECT_LE(drawn, 150) << filter << " " << degrees;
        }
}

TEST(Contours, AreEmptyOnFlatAndNoisyAndSlantedPictures) {
    Image ramp = make_image(160, 120, 1, kMm, 0);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) ramp.row(y)[x] = static_cast<std::uint8_t>(40 + x);
    EXPECT_EQ(ink(edges_of(make_image(160, 120, 1, kMm, 90), "contours")), 0);
    EXPECT_EQ(ink(edges_of(ramp, "contours")), 0);
    for (const double deviation : {1.0, 5.0, 10.0, 20.0})
        EXPECT_LE(ink(edges_of(noisy(make_image(160, 120, 1, kMm, 128), deviation, 3), "contours")), 0.001) << deviation;
    // The plain method draws noise: that is why there is a floor.
    EXPECT_GE(ink(edges_of(noisy(make_image(160, 120, 1, kMm, 128), 10, 3), "sobel thin=yes")), 0.1);
}

// A picture of grain alone draws nothing, however it was stored; if anything stands out, even in the last corner, the whole
// picture is processed.
TEST(Contours, OfABlankWallAreNoneAndASmallThingIsFound) {
    for (const int height : {300, 333, 366, 399})
        for (const int place : {0, height / 2, height - 18}) {
            Image wall = make_image(300, height, 1, kMm, 200);
            EXPECT_EQ(ink(edges_of(noisy(wall, 4, 3), "contours scene=0.95")), 0);
            for (int y = place; y < place + 18; ++y) std::fill_n(wall.row(y) + 100, 60, std::uint8_t{100});
            EXPECT_GT(ink(edges_of(noisy(wall, 4, 3), "contours scene=0.95")), 0) << height << ", " << place;
        }
}

// A scan's frame runs beside the border; a road runs out of it.
TEST(Contours, BesideTheBorderGoAndThoseThatRunOutOfItStay) {
    Image frame = make_image(160, 120, 1, kMm, 200);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            if (x < 3 || y < 3 || x >= 157 || y >= 117) frame.row(y)[x] = 40;
    EXPECT_EQ(ink(edges_of(frame, "contours surround=0")), 0);
    Image road = make_image(160, 120, 1, kMm, 200);
    for (int y = 0; y < 120; ++y) std::fill_n(road.row(y), 80, std::uint8_t{40});
    const EdgeMap edges = edges_of(road, "contours surround=0");
    for (const int y : {0, 1, 118, 119})
        EXPECT_TRUE(std::any_of(&edges.strength[static_cast<std::size_t>(y * 160 + 70)],
                                &edges.strength[static_cast<std::size_t>(y * 160 + 90)], [](float s) { return s > 0; }))
            << y;
}

// Black, white and middle grey are the picture's own: of two steps the same one is the stronger in a lighter copy.
TEST(Contours, ArePickedAlikeInALighterCopy) {
    Image image = make_image(160, 120, 3, kMm, 0);
    std::mt19937 random(9);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) {
            // A step in the shadows, one in the lights, and black and white.
            const int level = y < 10 ? 0 : y >= 110 ? 251 : x < 40 ? 20 : x < 80 ? 60 : x < 120 ? 200 : 120;
            std::fill_n(image.row(y) + 3 * x, 3, static_cast<std::uint8_t>(level + static_cast<int>(random() % 5)));
        }
    const auto shadow_to_light = [](const Image& picture) {
        const EdgeMap edges = edges_of(picture, "contours surround=0");
        const auto row = edges.strength.begin() + 60 * 160;
        return *std::max_element(row + 35, row + 45) / *std::max_element(row + 115, row + 125);
    };
    const auto lighter = [](Image picture, double power) {
        for (auto& v : picture.pixels) v = static_cast<std::uint8_t>(std::lround(255 * std::pow(v / 255.0, power)));
        return picture;
    };
    EXPECT_NEAR(shadow_to_light(lighter(image, 0.8)) / shadow_to_light(image), 1, 0.2);
}

// JPEG keeps colour at half the resolution, so fine colour is chance: it says less than fine light.
TEST(Contours, FollowColourAtAWiderScaleThanLight) {
    const auto wavy = [](bool colour, double wave) {
        Image image = make_image(160, 120, 3, kMm, 128);
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x) {
                const int by = static_cast<int>(std::lround(40 * std::sin(2 * std::numbers::pi * x / wave)));
                std::uint8_t* p = image.row(y) + 3 * x;
                p[0] = static_cast<std::uint8_t>(128 + by);
                p[1] = static_cast<std::uint8_t>(128 + (colour ? -by / 2 : by));
                p[2] = static_cast<std::uint8_t>(128 + (colour ? 0 : by));
            }
        return strongest(edges_of(image, "contours surround=0 blur=1mm"));
    };
    EXPECT_GT(wavy(false, 12) / wavy(false, 40), 1.3f * (wavy(true, 12) / wavy(true, 40)));
}

TEST(Contours, SeeColourThatLightnessHides) {
    Image image = make_image(64, 64, 3, kMm, 0);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            std::uint8_t* p = image.row(y) + 3 * x;
            // Both have luma 110: 0.299 * 200 + 0.587 * 62 + 0.114 * 124 and its counterpart.
            p[0] = x < 32 ? 200 : 60, p[1] = x < 32 ? 62 : 134, p[2] = x < 32 ? 124 : 118;
        }
    EXPECT_EQ(ink(edges_of(image, "canny high=10 low=5")), 0);
    EXPECT_GT(strongest(edges_of(image, "contours")), 40);
}

TEST(Contours, TextureIsHeldDownAgainstAContour) {
    Image image = make_image(128, 128, 1, kMm, 0);
    std::mt19937 random(5);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) image.row(y)[x] = x < 64 ? 170 : static_cast<std::uint8_t>(60 + random() % 60);
    const auto share_inside = [&](const char* filter) {
        const EdgeMap edges = edges_of(image, filter);
        double on_line = 0, inside = 0;
        for (int y = 16; y < 112; ++y)
            for (int x = 16; x < 120; ++x)
                (std::abs(x - 64) <= 3 ? on_line : inside) += edges.strength[static_cast<std::size_t>(y * 128 + x)];
        return inside / on_line;
    };
    EXPECT_LT(share_inside("contours"), 0.5 * share_inside("sobel thin=yes"));
}

TEST(EdgeMap, HysteresisKeepsPiecesThatReachHigh) {
    EdgeMap map;
    map.width = 40;
    map.height = 30;
    map.mm_per_pixel = kMm;
    std::mt19937 random(11);
    for (int i = 0; i < 1200; ++i) map.strength.push_back(random() % 3 == 0 ? static_cast<float>(random() % 100) : 0.0f);
    const EdgeMap kept = keep_connected(map, 30, 80);
    // Naive twin: let `high` pixels spread over `low` neighbours until nothing changes.
    std::vector<bool> lit(1200);
    for (std::size_t i = 0; i < 1200; ++i) lit[i] = map.strength[i] >= 80;
    for (bool changed = true; changed;) {
        changed = false;
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int nx = x + dx, ny = y + dy;
                        if (nx < 0 || ny < 0 || nx >= 40 || ny >= 30) continue;
                        const auto i = static_cast<std::size_t>(y * 40 + x), n = static_cast<std::size_t>(ny * 40 + nx);
                        if (!lit[i] && lit[n] && map.strength[i] >= 30) lit[i] = changed = true;
                    }
    }
    for (std::size_t i = 0; i < 1200; ++i) EXPECT_EQ(kept.strength[i] > 0, lit[i]) << i;
}

TEST(EdgeMap, NoiseIsMeasuredAndNotMistakenForThePicture) {
    for (const double deviation : {2.0, 5.0, 12.0})
        EXPECT_NEAR(noise_level(noisy(step_picture(128, 0.4, 60, 180), deviation, 9)), deviation, 0.15 * deviation + 0.2);
    EXPECT_EQ(noise_level(step_picture(128, 0, 0, 255)), 0);
    EXPECT_EQ(noise_level(make_image(2, 2, 1, kMm, 9)), 0);
}

TEST(Gradient, PoolingTurnsWithThePicture) {
    const Image image = noisy(step_picture(48, 0.5, 40, 200), 15, 21);
    Image turned = image;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x) turned.row(x)[47 - y] = image.row(y)[x];
    const auto pooled = [](const Image& picture) {
        return strongest_direction(gradient_tensor(grey_plane(picture), 1.5), 3, kMm);
    };
    const EdgeMap straight = pooled(image), other = pooled(turned);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
            ASSERT_NEAR(straight.strength[static_cast<std::size_t>(y * 48 + x)],
                        other.strength[static_cast<std::size_t>(x * 48 + 47 - y)], 0.02);
}

}  // namespace
}  // namespace tactics::edges_test
