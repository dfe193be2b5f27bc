// SPDX-License-Identifier: Apache-2.0
// Solids for 3-D printers: closed, in one piece, turned outwards, and as high as the map says.
#include <algorithm>
#include <functional>
#include <random>

#include "print/format.h"
#include "print/height_files.h"
#include "tactics/error.h"
#include "tests/cli/tool.h"
#include "tests/print/mesh.h"

namespace tactics::height_stl_test {
namespace {

using namespace tests;

HeightMap map_of(int columns, int rows, double pitch, const std::function<double(int, int)>& height) {
    HeightMap map{columns, rows, pitch, {}};
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) map.heights.push_back(static_cast<float>(height(x, y)));
    return map;
}

std::string stl_of(const HeightMap& map, double low, double high, double base) {
    return height_stl(sheet_of(map, low, high), rows_of(map), base, "--pitch");
}

// Steps, a smooth hill, and noise, the hardest case for leaving out corners.
std::vector<HeightMap> samples() {
    std::mt19937 chance(6);
    return {map_of(40, 30, 0.5, [](int x, int y) { return (x / 8 + y / 10) % 2 == 0 ? 0 : 3; }),
            map_of(57, 41, 0.3, [](int x, int y) { return 4 * std::exp(-((x - 28) * (x - 28) + (y - 20) * (y - 20)) / 150.0); }),
            map_of(33, 64, 0.2, [&](int, int) { return static_cast<double>(chance() % 3); })};
}

TEST(HeightStl, ThreeSamplesAreClosedSolids) {
    for (const HeightMap& map : samples()) expect_solid(mesh_of(stl_of(map, 0, 4, 2)));
}

TEST(HeightStl, TheCheckerSeesWhatIsWrong) {
    const StlMesh good = mesh_of(stl_of(samples()[0], 0, 4, 2));
    StlMesh hole = good, turned = good, flat = good;
    hole.triangles.pop_back();
    hole.normals.pop_back();
    EXPECT_EQ(faults_of(hole).open_edges, 3u);
    std::swap(turned.triangles[7][0], turned.triangles[7][1]);
    EXPECT_GT(faults_of(turned).open_edges, 0u);
    EXPECT_EQ(faults_of(turned).wrong_normals, 1u);
    flat.triangles[7][0] = flat.triangles[7][1];
    EXPECT_EQ(faults_of(flat).flat, 1u);
    // Two boxes that touch at a corner.
    StlMesh twice = mesh_of(stl_of(map_of(1, 1, 1, [](int, int) { return 0; }), 0, 1, 1));
    const std::size_t count = twice.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
        auto other = twice.triangles[i];
        for (auto& corner : other)
            for (float& value : corner) value += 1;
        twice.triangles.push_back(other);
        twice.normals.push_back(twice.normals[i]);
    }
    EXPECT_EQ(faults_of(twice).crossed, 1u);
}

TEST(HeightStl, AnotherProgramFindsNothingToMend) {
    if (!has_tool("admesh")) GTEST_SKIP() << "admesh is not installed";
    for (const HeightMap& map : samples()) {
        const Folder folder;
        write_bytes(folder / "relief.stl", stl_of(map, 0, 4, 2));
        const Ending ending = run_tool(folder, {"admesh", "relief.stl"});
        EXPECT_EQ(ending.code, 0) << ending.err;
        for (const char* line :
             {"Total disconnected facets        :     0                   0", "Number of parts       :     1 ",
              "Degenerate facets     :     0", "Edges fixed           :     0", "Facets removed        :     0",
              "Facets added          :     0", "Facets reversed       :     0", "Backwards edges       :     0",
              "Normals fixed         :     0"})
            EXPECT_TRUE(holds(ending.out, line)) << line << "\n" << ending.out;
    }
}

// The height of the surface above a place, by all triangles.
double top_at(const StlMesh& mesh, double x, double y) {
    double top = -1;
    for (const auto& [a, b, c] : mesh.triangles) {
        const double area = (static_cast<double>(b[0]) - a[0]) * (static_cast<double>(c[1]) - a[1]) -
                            (static_cast<double>(c[0]) - a[0]) * (static_cast<double>(b[1]) - a[1]);
        if (area <= 0) continue;  // sides, bottom
        const double v =
            ((x - a[0]) * (static_cast<double>(c[1]) - a[1]) - (static_cast<double>(c[0]) - a[0]) * (y - a[1])) / area;
        const double w =
            ((static_cast<double>(b[0]) - a[0]) * (y - a[1]) - (x - a[0]) * (static_cast<double>(b[1]) - a[1])) / area;
        if (v < -1e-6 || w < -1e-6 || v + w > 1 + 1e-6) continue;
        top = std::max(top, a[2] + v * (static_cast<double>(b[2]) - a[2]) + w * (static_cast<double>(c[2]) - a[2]));
    }
    return top;
}

TEST(HeightStl, EverySampleKeepsItsHeight) {
    for (const HeightMap& map : samples()) {
        const StlMesh mesh = mesh_of(stl_of(map, 0, 4, 2));
        for (int y = 0; y < map.rows; y += 3)
            for (int x = 0; x < map.columns; x += 2)
                ASSERT_NEAR(top_at(mesh, (x + 0.5) * map.pitch, map.height() - (y + 0.5) * map.pitch), 2 + map.at(x, y), 1e-4)
                    << x << " " << y;
    }
}

// Between four samples the surface is between their heights, also where corners were left out.
TEST(HeightStl, TheSurfaceStaysBetweenItsSamples) {
    for (const HeightMap& map : {samples()[0], map_of(30, 30, 0.5, [](int x, int y) { return y > 14 && x % 7 == 3 ? 3 : 0; })}) {
        const StlMesh mesh = mesh_of(stl_of(map, 0, 4, 2));
        for (int y = 0; y + 1 < map.rows; ++y)
            for (int x = 0; x + 1 < map.columns; x += 2) {
                const auto [least, most] = std::minmax({map.at(x, y), map.at(x + 1, y), map.at(x, y + 1), map.at(x + 1, y + 1)});
                const double top = top_at(mesh, (x + 1.1) * map.pitch, map.height() - (y + 0.95) * map.pitch) - 2;
                ASSERT_GE(top, least - 1e-4) << x << " " << y;
                ASSERT_LE(top, most + 1e-4) << x << " " << y;
            }
    }
}

TEST(HeightStl, StandsOnItsPlateAndIsAsLargeAsTheMap) {
    const HeightMap map = map_of(40, 20, 0.5, [](int x, int) { return x < 20 ? -1 : 2; });
    const StlMesh mesh = mesh_of(stl_of(map, -1, 2, 1.5));
    Vertex least{9e9f, 9e9f, 9e9f}, most{-9e9f, -9e9f, -9e9f};
    for (const auto& triangle : mesh.triangles)
        for (const Vertex& corner : triangle)
            for (std::size_t k = 0; k < 3; ++k) {
                least[k] = std::min(least[k], corner[k]);
                most[k] = std::max(most[k], corner[k]);
            }
    EXPECT_EQ(least, (Vertex{0, 0, 0}));
    EXPECT_EQ(most, (Vertex{20, 10, 4.5f}));
    // Half of it 1.5 mm thick, half 4.5 mm, between them half a pitch of slope either way.
    EXPECT_NEAR(mesh.volume(), 20 * 10 * 3.0, 1e-3);
}

TEST(HeightStl, LevelGroundNeedsFewTriangles) {
    const auto size = [](double step) {
        return stl_of(map_of(200, 200, 0.5, [=](int x, int y) { return x == 100 && y == 100 ? step : 0.0; }), 0, 1, 2).size();
    };
    EXPECT_LT(size(0), 84 + 50 * 2000u);
    EXPECT_LT(size(1), 84 + 50 * 2100u);
    EXPECT_GT(size(1), size(0));
}

TEST(HeightStl, TheSmallestMapsAreSolidsToo) {
    for (const auto& [columns, rows] : std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {7, 1}, {2, 2}, {3, 1}}) {
        const HeightMap map = map_of(columns, rows, 0.5, [](int x, int y) { return (x + y) % 2; });
        const StlMesh mesh = mesh_of(stl_of(map, 0, 1, 0.2));
        expect_solid(mesh);
        EXPECT_NEAR(top_at(mesh, 0.25, map.height() - 0.25), 0.2, 1e-6);
    }
}

TEST(HeightStl, WhatIsNoNumberIsTheLowest) {
    HeightMap map = map_of(9, 9, 0.5, [](int, int) { return 1; });
    map.at(4, 4) = std::nanf("");
    map.at(2, 4) = INFINITY;
    const StlMesh mesh = mesh_of(stl_of(map, 0, 2, 1));
    expect_solid(mesh);
    EXPECT_NEAR(top_at(mesh, 2.25, 2.25), 1, 1e-6);
    EXPECT_NEAR(top_at(mesh, 1.25, 2.25), 3, 1e-6);
}

TEST(HeightStl, TooManyTrianglesAreRefused) {
    const HeightSheet sheet{4000, 4000, 0.1, 0, 1, {}};
    const auto noisy = [](int row, std::span<float> heights) {
        for (std::size_t x = 0; x < heights.size(); ++x) heights[x] = static_cast<float>((x + static_cast<std::size_t>(row)) % 2);
    };
    try {
        height_stl(sheet, noisy, 2, "--pitch");
        FAIL() << "16 million samples were taken";
    } catch (const Error& error) {
        EXPECT_TRUE(holds(error.what(), "--pitch: ")) << error.what();
        EXPECT_TRUE(holds(error.what(), "take a larger pitch")) << error.what();
    }
}

TEST(HeightStl, APageIsASolid) {
    Page page;
    page.width = 60;
    page.height = 40;
    page.strokes.push_back({{{5, 5}, {50, 30}, {20, 35}}, true, 1.2});
    page.areas.push_back({{{{30, 5}, {55, 5}, {55, 15}}}});
    const Format* format = find_format("stl");
    ASSERT_NE(format, nullptr);
    EXPECT_EQ(format_of_path("page.STL"), format);
    Settings settings(format->options);
    settings.set("base", "1mm", "", "stl");
    const StlMesh mesh = mesh_of(format->encode(page, settings));
    expect_solid(mesh);
    EXPECT_NEAR(top_at(mesh, 50.1, 31.1), 1.5, 1e-4);  // in the area, y upwards
    EXPECT_NEAR(top_at(mesh, 10.1, 10.1), 1, 1e-6);
}

}  // namespace
}  // namespace tactics::height_stl_test
