// SPDX-License-Identifier: Apache-2.0
// Models from above: solids whose heights are known, in both kinds of STL, and files that are none.
#include "tactics/relief/depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "tactics/error.h"
#include "tactics/readers/stl.h"
#include "tactics/relief/read_heights.h"
#include "tactics/units.h"

namespace tactics::depth_test {
namespace {

using Corner = std::array<double, 3>;
using Model = std::vector<Triangle>;

void add_side(Model& model, const std::vector<Corner>& corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) model.push_back({{corners[0], corners[i], corners[i + 1]}});
}

Model cube(Corner low, double size) {
    Model model;
    const auto at = [&](int x, int y, int z) { return Corner{low[0] + x * size, low[1] + y * size, low[2] + z * size}; };
    add_side(model, {at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)});
    add_side(model, {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
    add_side(model, {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)});
    add_side(model, {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)});
    add_side(model, {at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1)});
    add_side(model, {at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1)});
    return model;
}

Model pyramid(double side, double tall) {
    const Corner a{0, 0, 0}, b{side, 0, 0}, c{side, side, 0}, d{0, side, 0}, top{side / 2, side / 2, tall};
    return {{{a, d, c}}, {{a, c, b}}, {{a, b, top}}, {{b, c, top}}, {{c, d, top}}, {{d, a, top}}};
}

Model sphere(double radius, int steps) {
    Model model;
    const auto at = [&](int i, int j) {
        const double up = std::numbers::pi * i / steps, around = 2 * std::numbers::pi * (j % (2 * steps)) / (2 * steps);
        return Corner{radius * std::sin(up) * std::cos(around), radius * std::sin(up) * std::sin(around), radius * std::cos(up)};
    };
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < 2 * steps; ++j) add_side(model, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return model;
}

std::string binary(const Model& model, const std::string& header = "binary") {
    std::string bytes = header;
    bytes.resize(84, ' ');
    const auto count = static_cast<std::uint32_t>(model.size());
    std::memcpy(bytes.data() + 80, &count, 4);
    for (const Triangle& triangle : model) {
        std::array<float, 12> numbers{};
        for (std::size_t k = 0; k < 9; ++k) numbers[3 + k] = static_cast<float>(triangle.corners[k / 3][k % 3]);
        bytes.append(reinterpret_cast<const char*>(numbers.data()), 48);
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string text(const Model& model) {
    std::string all = "solid a thing of facet and vertex\n";
    for (const Triangle& triangle : model) {
        all += "  facet normal 0 0 0\r\n    outer loop\n";
        for (const auto& [x, y, z] : triangle.corners)
            all += "      vertex " + to_text(x) + "\t" + to_text(y) + " " + to_text(z) + "e+00\n";
        all += "    endloop\n  endfacet\n";
    }
    return all + "endsolid a thing\n";
}

HeightFile read(const std::string& bytes, const HeightWish& wish = {}, const std::string& name = "model.stl") {
    Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, name);
    return read_heights(source, wish);
}

std::string complaint(const std::string& bytes, const HeightWish& wish = {}, const std::string& name = "model.stl") {
    try {
        read(bytes, wish, name);
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
}

bool has(const std::string& all, std::string_view part) { return all.find(part) != std::string::npos; }

TEST(Depth, OfACubeIsItsTopFromEdgeToEdge) {
    for (const std::string& bytes :
         {binary(cube({-7, 3, 100}, 20)), text(cube({-7, 3, 100}, 20)), binary(cube({-7, 3, 100}, 20), "solid but binary")}) {
        const HeightFile file = read(bytes, {.pitch = 0.5});
        EXPECT_EQ(file.format, "STL model");
        EXPECT_EQ(file.map.columns, 40);
        EXPECT_EQ(file.map.rows, 40);
        EXPECT_EQ(file.map.pitch, 0.5);
        EXPECT_EQ(file.low, 0);
        EXPECT_EQ(file.high, 20);
        for (const float height : file.map.heights) ASSERT_EQ(height, 20.0f);
    }
}

TEST(Depth, OfAPyramidIsExact) {
    const HeightFile file = read(binary(pyramid(30, 12)), {.pitch = 0.25});
    ASSERT_EQ(file.map.columns, 120);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 120; ++x) {
            const double u = (x + 0.5) * 0.25, v = (y + 0.5) * 0.25, inwards = std::min({u, v, 30 - u, 30 - v});
            ASSERT_NEAR(file.map.at(x, y), 12 * inwards / 15, 1e-5) << x << " " << y;
        }
}

TEST(Depth, OfASphereIsExactToItsFacets) {
    const double radius = 10, pitch = 0.2;
    const int steps = 180;
    const HeightFile file = read(binary(sphere(radius, steps)), {.pitch = pitch});
    ASSERT_EQ(file.map.columns, 100);
    const double sagitta = radius * (1 - std::pow(std::cos(std::numbers::pi / steps / 2), 2));
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const double u = (x + 0.5) * pitch - radius, v = (y + 0.5) * pitch - radius, rest = radius * radius - u * u - v * v;
            if (rest < 0) {
                ASSERT_LE(file.map.at(x, y), 0.0f) << "nothing is there";
                continue;
            }
            if (rest < 1) continue;  // where it falls away, a facet is far from the ball in height
            const double height = radius + std::sqrt(rest);
            ASSERT_NEAR(file.map.at(x, y), height, sagitta * radius / std::sqrt(rest) + 1e-4) << x << " " << y;
        }
}

// A surface of many triangles has no gaps between them, wherever samples fall.
TEST(Depth, HasNoHolesOnSharedEdges) {
    Model model;
    const int cells = 48;
    const auto at = [](int x, int y) { return Corner{x * 0.5, y * 0.5, 5 + 0.01 * x - 0.02 * y}; };
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            for (const auto& half :
                 {std::array{at(x, y), at(x + 1, y), at(x + 1, y + 1)}, std::array{at(x, y), at(x + 1, y + 1), at(x, y + 1)}})
                model.push_back({{half[0], half[1], half[2]}});
    model.push_back({{Corner{0, 0, 0}, Corner{24, 0, 0}, Corner{0, 24, 0}}});
    // Centres on corners, on edges and on diagonals, and beside them.
    for (const double pitch : {0.5, 1.0, 0.25, 0.3, 0.7}) {
        const HeightFile file = read(binary(model), {.pitch = pitch});
        for (int y = 1; y + 1 < file.map.rows; ++y)
            for (int x = 1; x + 1 < file.map.columns; ++x) ASSERT_GT(file.map.at(x, y), 3.9f) << pitch << " " << x << " " << y;
    }
}

TEST(Depth, YGoesUpAndTheHighestSurfaceCounts) {
    Model model = cube({0, 0, 0}, 10);
    for (const Triangle& triangle : cube({0, 8, 10}, 2)) model.push_back(triangle);
    for (const Triangle& triangle : cube({4, 4, 3}, 2)) model.push_back(triangle);  // inside
    const HeightMap map = read(binary(model), {.pitch = 1}).map;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) EXPECT_EQ(map.at(x, y), x < 2 && y < 2 ? 12.0f : 10.0f) << x << " " << y;
}

TEST(Depth, WidthAndHeightsAsTheUserWants) {
    const std::string bytes = binary(pyramid(0.4, 0.2));  // of a model in metres
    const HeightFile wide = read(bytes, {.pitch = 1, .width = 100});
    EXPECT_EQ(wide.map.columns, 100);
    EXPECT_NEAR(wide.high, 50, 1e-4);
    EXPECT_NEAR(wide.map.at(50, 50), 49.5, 1e-4);
    EXPECT_TRUE(wide.notes.empty());
    const HeightFile low = read(bytes, {.pitch = 1, .width = 100, .low = -2, .high = 8});
    EXPECT_NEAR(low.map.at(50, 50), -2 + 10 * 0.99, 1e-4);
    const HeightFile mould = read(bytes, {.pitch = 1, .width = 100, .low = -2, .high = 8, .invert = true});
    EXPECT_NEAR(mould.map.at(50, 50), 8 - 10 * 0.99, 1e-4);
    const HeightFile silent = read(bytes);
    ASSERT_EQ(silent.notes.size(), 2u);
    EXPECT_TRUE(has(silent.notes[0].english(), "0.1 mm is taken; change with --pitch"));
    EXPECT_TRUE(has(silent.notes[1].english(), "0.4 mm wide; change with --width"));
    EXPECT_EQ(silent.map.columns, 4);
}

TEST(Depth, WhatIsNoModelIsRefused) {
    const std::string good = binary(cube({0, 0, 0}, 10)), words = text(cube({0, 0, 0}, 10));
    EXPECT_TRUE(
        has(complaint(good.substr(0, good.size() - 1)),
            "model.stl: is cut short, or is no STL model: it says that it has 12 triangles, which are 684 bytes, and has 683"));
    EXPECT_TRUE(has(complaint(good.substr(0, 50)), "is cut short in its first 84 bytes"));
    std::string many = good;
    std::memset(many.data() + 80, 0xFF, 4);
    EXPECT_TRUE(has(complaint(many), "4294967295 triangles"));
    std::string broken = good;
    std::memset(broken.data() + 84 + 50 + 12, 0xFF, 4);
    EXPECT_TRUE(has(complaint(broken), "a corner that is no number, in triangle 2"));
    EXPECT_TRUE(has(complaint(binary({})), "has no triangles"));
    EXPECT_TRUE(has(complaint("solid\nendsolid\n"), "has no triangles"));
    EXPECT_TRUE(has(complaint(words.substr(0, words.size() / 2)), "the file ends"));
    EXPECT_TRUE(has(complaint("solid x\nfacet\nvertex 1 2 three\n"), "model.stl:3: \"three\" is no number"));
    EXPECT_TRUE(has(complaint("solid x\nfacet\nvertex 1 2 nan\n"), "\"nan\" is no number"));
    EXPECT_TRUE(has(complaint("solid x\nfacet vertex 0 0 0 vertex 1 1 1 endfacet"), "a facet has 2 corners"));
    EXPECT_TRUE(has(complaint("solid x\nfacet\nsurface\n"), "\"surface\" is no word of an STL"));
    EXPECT_TRUE(has(complaint("solid x\n" + std::string(100'000, 'x')), "a word of over 100 letters"));
    EXPECT_TRUE(has(complaint(text({{{Corner{0, 0, 0}, Corner{0, 5, 0}, Corner{0, 5, 5}}}})), "stands on its edge"));
    EXPECT_TRUE(has(complaint(binary({{{Corner{0, 0, 0}, Corner{3e38, 0, 0}, Corner{0, 3e38, 5}}}})),
                    "take a larger --pitch or a smaller --width"));
    EXPECT_TRUE(has(complaint(binary(cube({0, 0, 0}, 5000))), "50000 x 50000 samples; at most 120 million"));
    EXPECT_TRUE(has(complaint(good, {.pitch = 0.0001}), "--pitch: a pitch of 0.0001 mm is not from 0.001 mm to 1000 mm"));
}

}  // namespace
}  // namespace tactics::depth_test
