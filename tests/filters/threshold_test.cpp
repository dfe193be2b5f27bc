// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/filters/pictures.h"

namespace tactics::threshold_test {
namespace {

using namespace pictures;

constexpr const char* kMethods[] = {"fixed", "otsu", "adaptive", "hysteresis"};

std::string line(std::string_view method, std::string_view rest = "") {
    return "threshold method=" + std::string(method) + " " + std::string(rest);
}

EdgeMap edge_map(int width, std::vector<float> strength) {
    EdgeMap edges;
    edges.width = width;
    edges.height = static_cast<int>(strength.size()) / width;
    edges.mm_per_pixel = kPixel;
    edges.strength = std::move(strength);
    return edges;
}

TEST(Threshold, MakesPicturesBlackAndWhite) {
    for (const auto method : kMethods) {
        for (const Image& image : {random_grey(40, 30, 1), random_grey(1, 1, 2), random_grey(1, 9, 3), random_colour(9, 1, 4)}) {
            const Image cut = filtered_image(line(method), image);
            EXPECT_EQ(cut.channels, 1);
            EXPECT_EQ(count_level(cut, 0) + count_level(cut, 255), cut.pixels.size()) << method;
        }
    }
}

TEST(Threshold, FixedMakesInkOfWhatIsDarker) {
    const Image ramp = drawn(256, 1, [](int x, int) { return x; });
    EXPECT_EQ(count_level(filtered_image(line("fixed", "level=100"), ramp), 0), 100u);
    EXPECT_EQ(count_level(filtered_image(line("fixed", "level=99.5"), ramp), 0), 100u);
    EXPECT_EQ(count_level(filtered_image(line("fixed", "level=0"), ramp), 0), 0u);
    EXPECT_EQ(filtered_edges(line("fixed", "level=5"), edge_map(4, {4.9f, 5, 0, 80})).strength,
              std::vector<float>({0, 5, 0, 80}));
}

// Variance within the two classes that a level makes, straight from the pixels.
double within(const Image& image, int level) {
    double squares = 0;
    for (const bool ink : {true, false}) {
        double sum = 0;
        double count = 0;
        for (const auto v : image.pixels)
            if ((v < level) == ink) sum += v, ++count;
        for (const auto v : image.pixels)
            if ((v < level) == ink) squares += (v - sum / count) * (v - sum / count);
    }
    return squares;
}

TEST(Threshold, OtsuIsTheBestOfAllLevels) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Chance chance(seed);
        const double share = chance.unit();
        const Image image = drawn(
            30, 20, [&](int, int) { return chance.unit() < share ? 80 + 25 * chance.normal() : 190 + 10 * chance.normal(); });
        double least = INFINITY;
        for (int level = 1; level < 256; ++level) least = std::min(least, within(image, level));
        // The ink is everything up to some grey: find which.
        const Image cut = filtered_image(line("otsu"), image);
        int darkest_ground = 256;
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            if (cut.pixels[i] == 255) darkest_ground = std::min<int>(darkest_ground, image.pixels[i]);
        EXPECT_EQ(count_level(cut, 255), static_cast<std::size_t>(std::count_if(image.pixels.begin(), image.pixels.end(),
                                                                                [&](int v) { return v >= darkest_ground; })));
        EXPECT_NEAR(within(image, darkest_ground), least, 1e-6 * least);
    }
}

TEST(Threshold, OfPicturesThatAreBlackAndWhiteChangesNothing) {
    for (const char* rest : {"fixed", "otsu", "hysteresis"}) {
        for (const Image& image : {random_ink(20, 20, 1), make_image(5, 5, 1, kPixel, 0), make_image(5, 5, 1, kPixel, 255)})
            EXPECT_EQ(filtered_image(line(rest), image).pixels, image.pixels) << rest;
    }
    EXPECT_EQ(count_level(filtered_image(line("otsu"), make_image(5, 5, 1, kPixel, 140)), 255), 25u);
    EXPECT_EQ(count_level(filtered_image(line("otsu"), make_image(5, 5, 1, kPixel, 100)), 0), 25u);
}

TEST(Threshold, AdaptiveComparesWithTheMeanOfTheSquareAround) {
    const Image image = random_grey(25, 18, 1);
    for (const auto& [window, reach] : {std::pair("0.3mm", 0), std::pair("1mm", 2), std::pair("3mm", 6), std::pair("90mm", 25)}) {
        const Image cut = filtered_image(line("adaptive", std::string("offset=10 window=") + window), image);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                double sum = 0;
                for (int dy = -reach; dy <= reach; ++dy)
                    for (int dx = -reach; dx <= reach; ++dx)
                        sum += image.row(std::clamp(y + dy, 0, image.height - 1))[std::clamp(x + dx, 0, image.width - 1)];
                const double level = sum / ((2 * reach + 1) * (2 * reach + 1)) - 10;
                EXPECT_TRUE((cut.row(y)[x] == 0) == (image.row(y)[x] < level) || std::abs(image.row(y)[x] - level) < 1e-3)
                    << window;
            }
        }
    }
    // Uneven light: no single level finds the marks, this one does.
    const auto mark = [](int x, int y) { return x % 20 == 10 && y % 20 == 10; };
    const Image uneven = drawn(200, 40, [&](int x, int y) { return 50 + x - (mark(x, y) ? 30 : 0); });
    const Image cut = filtered_image(line("adaptive", "window=2mm"), uneven);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 200; ++x) EXPECT_EQ(cut.row(y)[x] == 0, mark(x, y)) << x << "," << y;
}

TEST(Threshold, HysteresisKeepsWhatHangsOnSomethingStrong) {
    const Image image =
        drawn(7, 1, [](int x, int) { return std::array{100, 10, 100, 200, 100, 100, 200}[static_cast<std::size_t>(x)]; });
    EXPECT_EQ(filtered_image(line("hysteresis", "low=50 high=150"), image).pixels,
              std::vector<std::uint8_t>({0, 0, 0, 255, 255, 255, 255}));
    EXPECT_EQ(filtered_image(line("hysteresis", "low=150 high=50"), image).pixels,
              std::vector<std::uint8_t>({0, 0, 0, 255, 255, 255, 255}));
    // By corners too; the strengths stay as they are.
    const EdgeMap edges = edge_map(4, {30, 0, 0, 30,  //
                                       0, 80, 0, 0,   //
                                       0, 0, 19, 0});
    EXPECT_EQ(filtered_edges(line("hysteresis", "low=20 high=60"), edges).strength,
              std::vector<float>({30, 0, 0, 0, 0, 80, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(count_set(filtered_edges(line("hysteresis", "low=0 high=0"), edges)), 4u);
}

TEST(Threshold, OtsuOfEdgesPartsWeakFromStrong) {
    EXPECT_EQ(filtered_edges(line("otsu"), edge_map(8, {0, 0, 0, 2, 3, 70, 90, 80})).strength,
              std::vector<float>({0, 0, 0, 0, 0, 70, 90, 80}));
    EXPECT_EQ(count_set(filtered_edges(line("otsu"), edge_map(3, {0, 0, 0}))), 0u);
    EdgeMap ridges = edge_map(10, {0, 0, 0, 0, 0, 0, 40, 44, 90, 94});
    ridges.thinned = true;
    EXPECT_EQ(filtered_edges(line("otsu"), ridges).strength, std::vector<float>({0, 0, 0, 0, 0, 0, 0, 0, 90, 94}));
    EXPECT_EQ(filtered_edges(line("adaptive", "window=2mm offset=8"), edge_map(9, {0, 0, 0, 50, 0, 0, 0, 0, 3})).strength,
              std::vector<float>({0, 0, 0, 50, 0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace tactics::threshold_test
