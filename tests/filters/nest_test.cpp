// SPDX-License-Identifier: Apache-2.0
// Regions that nest and the outlines chosen from them: the laws of the planar map and of the tree, and what is drawn of simple
// scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "filters/arc_worth.h"
#include "filters/outline_choice.h"
#include "filters/part_room.h"
#include "filters/region_arcs.h"
#include "filters/watershed.h"
#include "tactics/measure/whole.h"
#include "tests/filters/pictures.h"
#include "tests/filters/weights.h"

namespace tactics::nest_test {
namespace {

using pictures::Chance;

std::vector<std::uint32_t> random_labels(int width, int height, int kinds, std::uint64_t seed) {
    Chance chance(seed);
    std::vector<std::uint32_t> labels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (auto& label : labels) label = static_cast<std::uint32_t>(chance.below(kinds));
    return labels;
}

Image in_colour(int width, int height, double mm, const std::function<std::array<int, 3>(int, int)>& colour) {
    Image image = make_image(width, height, 3, mm, 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto c = colour(x, y);
            for (int k = 0; k < 3; ++k)
                image.row(y)[3 * x + k] = static_cast<std::uint8_t>(std::clamp(c[static_cast<std::size_t>(k)], 0, 255));
        }
    return image;
}

// A red disc before green and blue, with grain.
Image disc_scene(bool disc = true) {
    Chance chance(5);
    return in_colour(480, 320, 0.5, [&](int x, int y) -> std::array<int, 3> {
        const int grain = static_cast<int>(4 * chance.normal());
        if (disc && std::hypot(x - 200, y - 150) < 80) return {200 + grain, 60 + grain, 50 + grain};
        return disc && y > 190 ? std::array<int, 3>{70 + grain, 140 + grain, 60 + grain}
                               : std::array<int, 3>{120 + grain, 160 + grain, 220 + grain};
    });
}

RegionTree nested(const Image& image, std::string_view settings) {
    return std::get<RegionTree>(pictures::filtered("nest " + std::string(settings), image));
}

TEST(Basins, CoverTheMapAndEachHangsTogether) {
    EdgeMap map{40, 30, 1, false, {}, {}, {}};
    Chance chance(3);
    for (int i = 0; i < 40 * 30; ++i) map.strength.push_back(static_cast<float>(chance.below(256)));
    const auto basin = basins_of(map);
    // Naive: what hangs together by sides and has one number is one piece; as many pieces as numbers.
    std::vector<int> piece(basin.size(), -1);
    int pieces = 0;
    for (int start = 0; start < 40 * 30; ++start) {
        if (piece[static_cast<std::size_t>(start)] >= 0) continue;
        std::vector<int> front{start};
        piece[static_cast<std::size_t>(start)] = pieces;
        while (!front.empty()) {
            const int i = front.back(), x = i % 40;
            front.pop_back();
            for (const int j : {x > 0 ? i - 1 : -1, x < 39 ? i + 1 : -1, i - 40, i + 40})
                if (j >= 0 && j < 40 * 30 && piece[static_cast<std::size_t>(j)] < 0 &&
                    basin[static_cast<std::size_t>(j)] == basin[static_cast<std::size_t>(i)]) {
                    piece[static_cast<std::size_t>(j)] = pieces;
                    front.push_back(j);
                }
        }
        ++pieces;
    }
    EXPECT_EQ(static_cast<std::uint32_t>(pieces), *std::max_element(basin.begin(), basin.end()) + 1);
    EXPECT_GT(pieces, 10);
}

TEST(Basins, MeetOnTheRidge) {
    EdgeMap map{60, 20, 1, false, {}, {}, {}};
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 60; ++x) map.strength.push_back(static_cast<float>(std::max(0, 100 - 20 * std::abs(x - 23))));
    const auto basin = basins_of(map);
    EXPECT_EQ(*std::max_element(basin.begin(), basin.end()), 1u);
    for (int y = 0; y < 20; ++y) {
        EXPECT_EQ(basin[static_cast<std::size_t>(y * 60 + 22)], basin[0]);
        EXPECT_EQ(basin[static_cast<std::size_t>(y * 60 + 24)], basin[59]);
    }
}

// Each side between two labels is in one arc, with these two on its sides; arcs meet in junctions only; and as many junctions,
// arcs, regions and pieces as L. Euler says.
TEST(PlanarMap, HasEachSideOnce) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        constexpr int kWidth = 17, kHeight = 13;
        const auto labels = random_labels(kWidth, kHeight, 2 + static_cast<int>(seed) % 3, seed);
        const auto label = [&](int x, int y) { return labels[static_cast<std::size_t>(y * kWidth + x)]; };
        const PlanarMap map = planar_map_of(labels, kWidth, kHeight);
        std::map<std::tuple<int, int, bool>, int> seen;  // the pixel to the right or below, and whether the side goes down
        for (const RegionArc& arc : map.arcs) {
            const std::size_t steps = arc.points.size() - (arc.closed ? 0 : 1);
            for (std::size_t i = 0; i < steps; ++i) {
                const Point a = arc.points[i], b = arc.points[(i + 1) % arc.points.size()];
                ASSERT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y), 1);
                const int x = static_cast<int>(std::min(a.x, b.x)), y = static_cast<int>(std::min(a.y, b.y));
                const bool down = a.x == b.x;
                ++seen[{x, y, down}];
                const std::uint32_t before = down ? label(x - 1, y) : label(x, y - 1), after = label(x, y);
                ASSERT_NE(before, after);
                // Going down, what lies to the right of the picture is on the left of the way.
                const bool forward = down ? b.y > a.y : b.x < a.x;
                EXPECT_EQ(arc.faces[0], forward ? after : before);
                EXPECT_EQ(arc.faces[1], forward ? before : after);
            }
            for (const int end : {0, 1}) {
                const int junction = arc.junctions[static_cast<std::size_t>(end)];
                ASSERT_EQ(junction < 0, arc.closed);
                if (arc.closed) continue;
                const Point at = map.junctions[static_cast<std::size_t>(junction)],
                            p = end == 0 ? arc.points.front() : arc.points.back();
                EXPECT_TRUE(at.x == p.x && at.y == p.y);
            }
        }
        std::size_t sides = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                sides += x > 0 && label(x - 1, y) != label(x, y) ? 1 : 0;
                sides += y > 0 && label(x, y - 1) != label(x, y) ? 1 : 0;
            }
        EXPECT_EQ(seen.size(), sides);
        for (const auto& [side, times] : seen) EXPECT_EQ(times, 1);
    }
}

TEST(RegionTree, LevelsOfArcsAreThoseAtWhichTheirFacesMeet) {
    const RegionTree tree = nested(disc_scene(), "map=plain smallest=2mm");
    ASSERT_GT(tree.faces(), 5u);
    for (const RegionArc& arc : tree.arcs) {
        std::set<int> above;
        for (int n = static_cast<int>(arc.faces[0]); n >= 0; n = tree.nodes[static_cast<std::size_t>(n)].parent) above.insert(n);
        int n = static_cast<int>(arc.faces[1]);
        while (above.count(n) == 0) n = tree.nodes[static_cast<std::size_t>(n)].parent;
        EXPECT_FLOAT_EQ(arc.level, tree.nodes[static_cast<std::size_t>(n)].level);
    }
}

TEST(RegionTree, CoarserRegionsAreMadeOfFinerOnes) {
    const RegionTree tree = nested(disc_scene(), "map=plain smallest=2mm");
    auto before = regions_at(tree, 0);
    for (float level = 10; level <= 250; level += 20) {
        const auto now = regions_at(tree, level);
        std::map<std::uint32_t, std::uint32_t> in;
        for (std::size_t i = 0; i < now.size(); ++i) EXPECT_EQ(in.emplace(before[i], now[i]).first->second, now[i]);
        before = now;
    }
    const auto all = regions_at(tree, 255);
    EXPECT_EQ(*std::max_element(all.begin(), all.end()), 0u) << "above all levels there is one region";
}

class OutlinesBy : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (GetParam() == std::string("learned")) SKIP_WITHOUT_WEIGHTS();
    }
    Drawing outlines_of(const Image& image, const std::string& settings = "") const {
        return std::get<Drawing>(pictures::filtered("outlines " + settings, nested(image, std::string("map=") + GetParam())));
    }
};

TEST_P(OutlinesBy, DrawADiscAndItsHorizonWhole) {
    const Drawing drawing = outlines_of(disc_scene());
    ASSERT_FALSE(drawing.strokes.empty());
    const WholeLines whole = whole_lines(drawing);
    EXPECT_EQ(whole.loose_ends, 0u);
    EXPECT_NEAR(whole.whole, whole.length, 1e-9);
    // The disc's ring is near enough everywhere, and nothing is far from ring and horizon.
    const auto off = [](Point p) { return std::min(std::abs(std::hypot(p.x - 100, p.y - 75) - 40), std::abs(p.y - 95)); };
    for (const Stroke& stroke : drawing.strokes)
        for (const Point p : stroke.points) EXPECT_LT(off(p), 3) << p.x << " " << p.y;
    for (int i = 0; i < 36; ++i) {
        const double a = i * 0.1745329;
        const Point ring{100.25 + 40 * std::cos(a), 75.25 + 40 * std::sin(a)};
        double nearest = 1e9;
        for (const Stroke& stroke : drawing.strokes)
            for (const Point p : stroke.points) nearest = std::min(nearest, distance(p, ring));
        EXPECT_LT(nearest, 4) << i;
    }
}

TEST_P(OutlinesBy, LeaveAWallWithGrainBlank) { EXPECT_TRUE(outlines_of(disc_scene(false)).strokes.empty()); }

TEST_P(OutlinesBy, KeepToTheBudget) {
    // 240 x 160 mm: side 196, (196 / 63)^(5/3) = 6.63 times as much as on a square of 63 mm.
    EXPECT_GT(total_stroke_length(outlines_of(disc_scene(), "line=160mm")), 300);
    EXPECT_LE(total_stroke_length(outlines_of(disc_scene(), "line=45mm")), 1.15 * 45 * 6.63);
    EXPECT_LE(total_stroke_length(outlines_of(disc_scene(), "line=5mm")), 1.15 * 5 * 6.63);
}

TEST_P(OutlinesBy, BarsAreNoLineAndHaveNone) {
    Image scene = disc_scene();
    constexpr int kBar = 20;
    for (const int y : {0, scene.height - kBar})
        std::fill(scene.row(y), scene.row(y) + kBar * scene.row_bytes(), std::uint8_t{0});
    const double first = kBar * scene.mm_per_pixel, last = (scene.height - kBar) * scene.mm_per_pixel;
    const Drawing drawing = outlines_of(scene, "");
    EXPECT_FALSE(drawing.strokes.empty());
    for (const Stroke& stroke : drawing.strokes) {
        for (const Point& p : stroke.points) EXPECT_TRUE(p.y > first - 0.01 && p.y < last + 0.01) << p.y;
        EXPECT_FALSE(
            std::all_of(stroke.points.begin(), stroke.points.end(), [&](Point p) { return p.y < first + 2 || p.y > last - 2; }));
    }
}

TEST_P(OutlinesBy, BarsStayNoLineWhenThePictureIsShrunk) {
    // Bars that end between the pixels of the copy, with a bright scene behind them.
    const Image scene = disc_scene();
    for (const int bar : {40, 41, 43, 45}) {
        Image image = make_image(scene.width * 2, scene.height * 2 + 2 * bar, 3, 0.1, 0);
        for (int y = 0; y < scene.height * 2; ++y)
            for (int x = 0; x < image.width; ++x) std::copy_n(scene.row(y / 2) + x / 2 * 3, 3, image.row(y + bar) + x * 3);
        const Image small = pictures::filtered_image("resample dpi=96", image);
        ASSERT_LT(small.width, image.width / 2);
        const double first = bar * 0.1, last = (image.height - bar) * 0.1;
        const Drawing drawing = outlines_of(small, "bend=0.5mm gap=1.5mm");
        EXPECT_FALSE(drawing.strokes.empty());
        double beside = 0;
        for (const Stroke& stroke : drawing.strokes)
            for (std::size_t i = 1; i < stroke.points.size(); ++i) {
                const Point a = stroke.points[i - 1], b = stroke.points[i];
                if (std::max(a.y, b.y) < first + 1.5 || std::min(a.y, b.y) > last - 1.5) beside += std::abs(a.x - b.x);
            }
        EXPECT_LT(beside, 3) << bar;
    }
}

TEST_P(OutlinesBy, NarrowPicturesKeepTheirProportions) {
    for (const int wide : {3, 7, 20}) {
        const Image strip = in_colour(wide, 150, 0.5, [](int, int y) -> std::array<int, 3> {
            return y < 70 ? std::array<int, 3>{20, 30, 40} : std::array<int, 3>{220, 200, 180};
        });
        const Drawing drawing = outlines_of(strip);
        EXPECT_NEAR(drawing.height, 75, 1e-9) << wide;
        EXPECT_NEAR(drawing.width, wide * 0.5, 0.1) << wide;
    }
}

INSTANTIATE_TEST_SUITE_P(Maps, OutlinesBy, testing::Values("learned", "plain"),
                         [](const auto& tested) { return std::string(tested.param); });

// Against all sets of arcs that close: of four squares in a row of which every border has its worth.
TEST(BestParts, AreTheBestOfAllThatFit) {
    RegionTree tree;
    tree.width = 40;
    tree.height = 10;
    tree.mm_per_pixel = 1;
    for (int i = 0; i < 400; ++i) tree.face.push_back(static_cast<std::uint32_t>(i % 40 / 10));
    const PlanarMap map = planar_map_of(tree.face, 40, 10);
    tree.arcs = map.arcs;
    tree.junctions = map.junctions;
    // ((0 1) (2 3))
    tree.nodes.resize(7);
    const int parents[] = {4, 4, 5, 5, 6, 6, -1};
    for (std::size_t i = 0; i < 7; ++i) {
        tree.nodes[i].parent = parents[i];
        tree.nodes[i].level = i < 4 ? 0.0f : 50.0f + static_cast<float>(i);
    }
    tree.nodes[4].children = {0, 1};
    tree.nodes[5].children = {2, 3};
    tree.nodes[6].children = {4, 5};
    const auto drawn = [&](const std::vector<float>& chances, double price, double most) {
        const Parts parts = best_parts(tree, chances, price, most);
        std::vector<bool> which;
        for (const RegionArc& arc : tree.arcs) which.push_back(parts.divides(arc));
        return which;
    };
    ASSERT_EQ(tree.arcs.size(), 3u);
    EXPECT_EQ(drawn({0.9f, 0.1f, 0.8f}, 0.5, 100), (std::vector<bool>{true, false, true}));
    EXPECT_EQ(drawn({0.9f, 0.1f, 0.8f}, 0.5, 15), (std::vector<bool>{true, false, false})) << "room for one";
    EXPECT_EQ(drawn({0.4f, 0.1f, 0.3f}, 0.5, 100), (std::vector<bool>{false, false, false}));
    EXPECT_EQ(drawn({0.1f, 0.9f, 0.1f}, 0.5, 100), (std::vector<bool>{false, true, false}));
}

TEST(WithRoom, NothingIsNarrowerThanTheGap) {
    // Stripes 4 wide between fields, a field with a thin arm, and a field.
    constexpr int kWidth = 120, kHeight = 60;
    std::vector<std::uint32_t> part;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            part.push_back(x < 30 ? 0u : x < 34 ? 1u : (x >= 90 && y < 20) || (x >= 50 && y >= 8 && y < 11) ? 3u : 2u);
    std::vector<float> worth(part.size(), 0.5f);
    for (int y = 0; y < kHeight; ++y)
        worth[static_cast<std::size_t>(y * kWidth + 30)] = 0.9f;  // the stripe's left side is the better one
    const RoomyParts roomy = with_room(part, worth, kWidth, kHeight, 10);
    const auto at = [&](int x, int y) { return roomy.part[static_cast<std::size_t>(y * kWidth + x)]; };
    EXPECT_EQ(at(29, 40), 0u);
    EXPECT_EQ(at(31, 40), 2u) << "of the two sides the better one stays";
    EXPECT_EQ(at(110, 5), 3u);
    EXPECT_EQ(at(60, 9), 2u) << "an arm is no region";
    int slender = 0;
    for (int x = 60; x < 73; ++x) slender += roomy.slender.ink(x, 9) ? 1 : 0;
    EXPECT_EQ(slender, 13) << "but a line";
}

}  // namespace
}  // namespace tactics::nest_test
