// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/filters/pictures.h"

namespace tactics::denoise_test {
namespace {

using namespace pictures;

constexpr const char* kMethods[] = {"gaussian", "median", "bilateral"};

std::string line(std::string_view method, std::string_view rest) {
    return "denoise method=" + std::string(method) + " " + std::string(rest);
}

int held(int i, int length) { return std::clamp(i, 0, length - 1); }

TEST(Denoise, MedianIsTheMiddleOfTheSortedWindow) {
    for (const Image& image : {random_grey(23, 17, 1), random_ink(30, 9, 2), random_grey(40, 1, 3), random_grey(1, 12, 4)}) {
        for (const auto& [size, reach] :
             {std::pair("0.3mm", 1), std::pair("1mm", 2), std::pair("1.75mm", 3), std::pair("5mm", 10)}) {
            const Image smooth = filtered_image(line("median", std::string("size=") + size), image);
            for (int y = 0; y < image.height; ++y) {
                for (int x = 0; x < image.width; ++x) {
                    std::vector<std::uint8_t> window;
                    for (int dy = -reach; dy <= reach; ++dy)
                        for (int dx = -reach; dx <= reach; ++dx)
                            window.push_back(image.row(held(y + dy, image.height))[held(x + dx, image.width)]);
                    std::sort(window.begin(), window.end());
                    ASSERT_EQ(smooth.row(y)[x], window[window.size() / 2]) << size << " at " << x << "," << y;
                }
            }
        }
    }
}

// In floating point, on every pixel, however wide.
double gaussian_at(const Image& image, double sigma, int x, int y) {
    const int reach = static_cast<int>(4 * sigma) + 1;
    double sum = 0;
    double weight = 0;
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            const double w = std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
            sum += w * image.row(held(y + dy, image.height))[held(x + dx, image.width)];
            weight += w;
        }
    }
    return sum / weight;
}

TEST(Denoise, GaussianIsAGaussianAtEveryWidth) {
    // A disc and grain; at 5 mm on pixels of 0.05 mm the blur is 42 pixels wide and worked out on a smaller copy.
    Chance chance(1);
    Image image = drawn(160, 120, [&](int x, int y) { return (std::hypot(x - 60, y - 50) < 30 ? 200 : 40) + chance.below(20); });
    for (const auto& [pixel, size] :
         {std::pair(0.25, 0.5), std::pair(0.25, 1.5), std::pair(0.25, 5.0), std::pair(0.05, 1.5), std::pair(0.05, 5.0)}) {
        image.mm_per_pixel = pixel;
        const Image smooth = filtered_image("denoise size=" + std::to_string(size), image);
        const double sigma = size / pixel / 2.35482;
        for (int y = 0; y < image.height; y += 13)
            for (int x = 0; x < image.width; x += 11)
                EXPECT_NEAR(smooth.row(y)[x], gaussian_at(image, sigma, x, y), 2.5) << sigma << " at " << x << "," << y;
    }
}

TEST(Denoise, BilateralTakesGrainAndKeepsSteps) {
    Chance chance(1);
    const Image image = drawn(60, 40, [&](int x, int) { return (x < 30 ? 60 : 180) + 8 * chance.normal(); });
    const auto deviation = [](const Image& picture, int from, int to, double mean) {
        double squares = 0;
        for (int y = 5; y < 35; ++y)
            for (int x = from; x < to; ++x) squares += (picture.row(y)[x] - mean) * (picture.row(y)[x] - mean);
        return std::sqrt(squares / (30 * (to - from)));
    };
    const Image sharp = filtered_image("denoise method=bilateral", image);
    const Image soft = filtered_image("denoise method=gaussian", image);
    EXPECT_LT(deviation(sharp, 5, 25, 60), 4);
    EXPECT_LT(deviation(sharp, 28, 30, 60), 6);
    EXPECT_GT(deviation(soft, 28, 30, 60), 20);
}

TEST(Denoise, LeavesFlatPicturesAndSmallSizesAlone) {
    for (const auto method : kMethods) {
        for (const int level : {0, 100, 255}) {
            const Image flat = make_image(30, 20, 1, kPixel, static_cast<std::uint8_t>(level));
            EXPECT_EQ(filtered_image(line(method, "size=5mm"), flat).pixels, flat.pixels) << method;
        }
        const Image image = random_grey(20, 20, 1);
        EXPECT_EQ(filtered_image(line(method, "size=0.24mm"), image).pixels, image.pixels) << method;
        EXPECT_NE(filtered_image(line(method, "size=0.5mm"), image).pixels, image.pixels) << method;
    }
}

TEST(Denoise, StandsTinyPicturesHugeSizesAndColour) {
    for (const auto method : kMethods) {
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 50), std::pair(50, 1), std::pair(3, 2)}) {
            for (Image image : {random_grey(width, height, 1), random_colour(width, height, 2)}) {
                image.mm_per_pixel = 0.002;  // 5 mm are 2500 pixels
                const Image smooth = filtered_image(line(method, "size=5mm"), image);
                EXPECT_EQ(smooth.pixels.size(), image.pixels.size());
                EXPECT_EQ(smooth.channels, image.channels);
                EXPECT_EQ(smooth.mm_per_pixel, image.mm_per_pixel);
            }
        }
    }
}

}  // namespace
}  // namespace tactics::denoise_test
