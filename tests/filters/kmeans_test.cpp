// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "filters/edge_noise.h"
#include "tests/filters/pictures.h"

namespace tactics::kmeans_test {
namespace {

using namespace pictures;

std::set<int> greys_of(const Image& image) { return {image.pixels.begin(), image.pixels.end()}; }

std::set<std::array<int, 3>> colours_of(const Image& image) {
    std::set<std::array<int, 3>> colours;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3)
        colours.insert({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
    return colours;
}

TEST(Kmeans, GivesAtMostKGreysInTheOrderOfTheOldOnes) {
    const Image image = random_grey(40, 30, 1);
    for (const char* line : {"kmeans k=1", "kmeans", "kmeans k=16", "kmeans k=5 method=iterative"}) {
        const Image cut = filtered_image(line, image);
        EXPECT_LE(greys_of(cut).size(), 16u);
        for (std::size_t i = 1; i < image.pixels.size(); ++i)
            EXPECT_TRUE(image.pixels[i - 1] > image.pixels[i] || cut.pixels[i - 1] <= cut.pixels[i]) << line;
    }
    EXPECT_EQ(greys_of(filtered_image("kmeans k=1", image)).size(), 1u);
    EXPECT_EQ(greys_of(filtered_image("kmeans k=4", image)).size(), 4u);
    EXPECT_EQ(filtered_image("kmeans seed=1", image).pixels, filtered_image("kmeans seed=9", image).pixels);
}

TEST(Kmeans, LeavesPicturesOfFewGreysAlone) {
    for (const char* line : {"kmeans k=4", "kmeans k=4 method=iterative", "kmeans k=16 colour=yes"}) {
        const Image flat = make_image(5, 4, 1, kPixel, 77);
        EXPECT_EQ(filtered_image(line, flat).pixels, flat.pixels) << line;
        const Image two = random_ink(9, 7, 2);
        EXPECT_EQ(filtered_image(line, two).pixels, two.pixels) << line;
        const Image one = make_image(1, 1, 1, kPixel, 3);
        EXPECT_EQ(filtered_image(line, one).pixels, one.pixels) << line;
    }
}

TEST(Kmeans, TakesColoursApartThatHaveTheSameGrey) {
    Image image = make_image(20, 10, 3, kPixel, 0);
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        const std::array<std::uint8_t, 3> red{200, 60, 60};
        const std::array<std::uint8_t, 3> green{60, 131, 61};  // the same luma
        const auto& colour = i / 3 % 20 < 10 ? red : green;
        std::copy(colour.begin(), colour.end(), image.pixels.begin() + static_cast<std::ptrdiff_t>(i));
    }
    EXPECT_EQ(filtered_image("kmeans k=2 colour=yes", image).pixels, image.pixels);
    EXPECT_EQ(greys_of(filtered_image("kmeans k=2 colour=no", image)).size(), 1u);

    EXPECT_EQ(colours_of(filtered_image("kmeans k=7 colour=yes", random_colour(30, 30, 3))).size(), 7u);
    EXPECT_EQ(colours_of(filtered_image("kmeans k=1 colour=yes", random_colour(30, 30, 3))).size(), 1u);
    EXPECT_EQ(filtered_image("kmeans", random_colour(8, 8, 4)).channels, 1);
}

TEST(Kmeans, GroupsColoursByHowTheyLook) {
    // CIELAB, by hand: L 55 to 58; a 29, 29, -31, -25; b 10, -24, 10, -22. So two classes are the reds and the greens.
    Image image = make_image(4, 1, 3, kPixel, 0);
    image.pixels = {184, 112, 116, 164, 116, 176, 72, 144, 112, 0, 152, 176};
    const std::vector<std::uint8_t> by_a{174, 114, 146, 174, 114, 146, 36, 148, 144, 36, 148, 144};
    EXPECT_EQ(filtered_image("kmeans k=2 colour=yes", image).pixels, by_a);
    EXPECT_EQ(filtered_image("kmeans k=4 colour=yes", image).pixels, image.pixels);
}

TEST(Kmeans, ReadsInColourOnlyWhenItIsToldTo) {
    EXPECT_FALSE(uses_colour(parse_recipe("kmeans", "own", filters())));
    EXPECT_TRUE(uses_colour(parse_recipe("kmeans colour=yes", "own", filters())));
}

EdgeMap map_of(std::vector<float> strength) {
    EdgeMap edges;
    edges.width = static_cast<int>(strength.size());
    edges.height = 1;
    edges.mm_per_pixel = kPixel;
    edges.strength = std::move(strength);
    return edges;
}

TEST(KmeansOfEdges, KeepsTheStrongestClassesAsTheyAre) {
    EdgeMap edges = map_of({0, 0, 0, 0, 10, 11, 50, 52, 200, 201});
    EXPECT_EQ(filtered_edges("kmeans k=4 keep=1", edges).strength, std::vector<float>({0, 0, 0, 0, 0, 0, 0, 0, 200, 201}));
    EXPECT_EQ(filtered_edges("kmeans k=4 keep=2", edges).strength, std::vector<float>({0, 0, 0, 0, 0, 0, 50, 52, 200, 201}));
    EXPECT_EQ(filtered_edges("kmeans k=4 keep=16", edges).strength, edges.strength);
    EXPECT_EQ(filtered_edges("kmeans k=4 keep=16 floor=11", edges).strength,
              std::vector<float>({0, 0, 0, 0, 0, 11, 50, 52, 200, 201}));
    // A thinned map: the zeros between the ridges are no class.
    edges.thinned = true;
    EXPECT_EQ(filtered_edges("kmeans k=3 keep=3", edges).strength, edges.strength);
    edges.strength = {0, 0, 0, 0, 0, 0, 40, 44, 90, 94};
    EXPECT_EQ(filtered_edges("kmeans k=2 keep=1", edges).strength, std::vector<float>({0, 0, 0, 0, 0, 0, 0, 0, 90, 94}));
    edges.thinned = false;
    EXPECT_EQ(filtered_edges("kmeans k=2 keep=1", edges).strength, edges.strength);
    edges.thinned = true;
    edges.strength = {0, 0, 0, 0, 10, 11, 50, 52, 200, 201};
    EXPECT_EQ(filtered_edges("kmeans k=3 keep=2", edges).strength, std::vector<float>({0, 0, 0, 0, 0, 0, 50, 52, 200, 201}));
}

TEST(KmeansOfEdges, TakesWhatIsNoNumberForNoEdge) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const char* line : {"kmeans", "kmeans method=iterative"}) {
        EXPECT_EQ(filtered_edges(line, map_of({0, nan, 0, infinity, 0, 90, -5, 0})).strength,
                  std::vector<float>({0, 0, 0, 0, 0, 90, 0, 0}))
            << line;
        EXPECT_EQ(count_set(filtered_edges(line, map_of({nan, nan}))), 0u);
        EdgeMap thinned = map_of({0, 0, nan});
        thinned.thinned = true;
        EXPECT_EQ(count_set(filtered_edges(line, thinned)), 0u);
    }
}

double disc(int x, int y) { return std::hypot(x - 100, y - 75) < 45 ? 1 : 0; }

TEST(KmeansOfEdges, DrawsNothingOfAnEmptyPicture) {
    EXPECT_EQ(count_set(filtered_edges("kmeans", edges_of(200, 150, 2, [](int, int) { return 128; }))), 0u);
    for (const double sigma : {1.0, 2.0, 4.0}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            Chance chance(seed);
            const EdgeMap noisy = edges_of(200, 150, sigma, [&](int, int) { return 128 + 10 * chance.normal(); });
            EXPECT_EQ(count_set(filtered_edges("kmeans", noisy)), 0u) << "blur " << sigma << ", seed " << seed;
            EXPECT_EQ(count_set(filtered_edges("threshold method=otsu", noisy)), 0u);
            EXPECT_EQ(count_set(filtered_edges("threshold method=adaptive", noisy)), 0u);
        }
    }
    // The plain method would have drawn something.
    Chance chance(1);
    EdgeMap unmeasured = edges_of(200, 150, 2, [&](int, int) { return 128 + 10 * chance.normal(); });
    unmeasured.thinned = true;
    EXPECT_GT(count_set(filtered_edges("kmeans", unmeasured)), 1000u);
    unmeasured.noise = 2.5;
    EXPECT_EQ(count_set(filtered_edges("kmeans", unmeasured)), 0u);
    // Slow and steep ramps, with the steps of 8-bit greys.
    for (const double slope : {0.02, 0.1, 0.5, 1.2})
        EXPECT_EQ(count_set(filtered_edges("kmeans", edges_of(200, 150, 2, [&](int x, int y) { return slope * (x + y / 4.0); }))),
                  0u)
            << slope;
}

TEST(KmeansOfEdges, DrawsTheSameOfAFaintPictureAsOfAStrongOne) {
    const auto shape = [](double contrast, double noise, std::uint64_t seed) {
        Chance chance(seed);
        return edges_of(200, 150, 2, [&](int x, int y) { return 60 + contrast * disc(x, y) + noise * chance.normal(); });
    };
    const auto strong = filtered_edges("kmeans", shape(150, 0, 1));
    EXPECT_GT(count_set(strong), 400u);
    const auto ring = [](const EdgeMap& edges) {
        for (int y = 0; y < edges.height; ++y)
            for (int x = 0; x < edges.width; ++x)
                if (edges.strength[static_cast<std::size_t>(y * edges.width + x)] > 0 &&
                    std::abs(std::hypot(x - 100, y - 75) - 45) > 5)
                    return false;
        return true;
    };
    EXPECT_TRUE(ring(strong));
    for (const auto& [contrast, noise] : {std::pair(4.0, 0.0), std::pair(10.0, 2.0), std::pair(100.0, 10.0)}) {
        const auto faint = filtered_edges("kmeans", shape(contrast, noise, 1));
        EXPECT_TRUE(ring(faint)) << contrast;
        EXPECT_GT(count_set(faint), count_set(strong) * 2 / 3) << contrast;
        EXPECT_LT(count_set(faint), count_set(strong) * 3 / 2) << contrast;
    }
}

TEST(EdgeNoise, IsTheScaleThatTheNoiseHas) {
    // A gradient of Gaussian noise n behind a blur of s pixels has the scale n / (2 s) in heights of steps: its components
    // have the deviation n / (sqrt(8 pi) s^2), a step of 1 the gradient 1 / (sqrt(2 pi) s).
    for (const double blur : {2.0, 3.0}) {
        Chance chance(5);
        const EdgeMap edges = edges_of(300, 200, blur, [&](int, int) { return 128 + 10 * chance.normal(); });
        EXPECT_NEAR(static_cast<double>(noise_of(edges)), 10 / (2 * blur), 0.1 * 10 / (2 * blur));
    }
}

}  // namespace
}  // namespace tactics::kmeans_test
