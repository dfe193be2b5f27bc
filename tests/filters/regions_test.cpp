// SPDX-License-Identifier: Apache-2.0
// Regions as textured areas: borders shared to the point, small and thin ones gone, textures that differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "filters/list.h"
#include "filters/region_borders.h"
#include "samples/draw/noise.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/texture.h"
#include "tactics/layout/texture_choice.h"
#include "tactics/page.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics::regions_test {
namespace {

constexpr double kPixel = 0.5;  // mm

template <typename Grey>
Image painted(int width, int height, const Grey& grey) {
    Image image = make_image(width, height, 1, kPixel, 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.row(y)[x] = static_cast<std::uint8_t>(grey(x, y));
    return image;
}

Drawing drawn(const Image& image, const std::string& settings = "") {
    const Step step = parse_step("regions " + settings, "test", filters());
    return std::get<Drawing>(step.filter->apply(image, step.settings));
}

double area_of(const std::vector<Point>& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2;
}
double area_of(const Area& area) {
    double all = 0, most = 0;
    for (const auto& ring : area.rings) {
        all += area_of(ring);
        most = std::max(most, area_of(ring));
    }
    return 2 * most - all;  // the outer ring without the holes
}

bool in_disc(int x, int y, double cx, double cy, double radius) { return std::hypot(x + 0.5 - cx, y + 0.5 - cy) < radius; }

TEST(Regions, ADiscOnAGroundIsOneAreaAndOneLine) {
    const Image image = painted(200, 160, [](int x, int y) { return in_disc(x, y, 90, 80, 50) ? 40 : 220; });
    const Drawing drawing = drawn(image);
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_TRUE(drawing.strokes[0].closed);
    EXPECT_EQ(drawing.strokes[0].strength, 180);
    for (const Point& p : drawing.strokes[0].points) EXPECT_NEAR(distance(p, {45, 40}), 25, 0.3);
    // The lighter class is blank, the darker has the ink.
    ASSERT_EQ(drawing.areas.size(), 1u);
    EXPECT_GT(drawing.areas[0].texture, 0);
    ASSERT_EQ(drawing.areas[0].rings.size(), 1u);
    EXPECT_NEAR(area_of(drawing.areas[0]), 3.14159 * 25 * 25, 15);
}

// Three sectors and a disc: each point of each line is a point of the areas on both sides, unless one is blank.
TEST(Regions, NeighboursShareTheirBorders) {
    const Image image = painted(240, 240, [](int x, int y) {
        if (in_disc(x, y, 120, 120, 35)) return 250;
        const double angle = std::atan2(y - 119.7, x - 120.2);
        return angle < -1 ? 20 : angle < 1.2 ? 100 : 180;
    });
    const Drawing drawing = drawn(image);
    EXPECT_EQ(drawing.areas.size(), 3u) << "one of four is blank";
    EXPECT_EQ(drawing.strokes.size(), 6u);
    std::set<std::pair<double, double>> corners;
    for (const Area& area : drawing.areas)
        for (const auto& ring : area.rings)
            for (const Point& p : ring) corners.insert({p.x, p.y});
    for (const Stroke& stroke : drawing.strokes) {
        EXPECT_FALSE(stroke.closed);
        for (const Point& p : stroke.points) EXPECT_TRUE(corners.contains({p.x, p.y}));
    }
    // Three lines come together at each of three places round the disc; the others end at the frame.
    std::map<std::pair<double, double>, int> ends;
    for (const Stroke& stroke : drawing.strokes)
        for (const Point& p : {stroke.points.front(), stroke.points.back()}) ++ends[{p.x, p.y}];
    EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [](const auto& end) { return end.second == 3; }), 3);
}

// On any picture: the regions fill it without gaps, each side of a border is another region, rings are whole.
TEST(Regions, BordersPartThePicture) {
    for (int round = 0; round < 20; ++round) {
        const int width = 3 + round * 2, height = 2 + round * 3, classes = 2 + round % 4;
        ClassMap map{width, height, {}};
        for (int i = 0; i < width * height; ++i)
            map.classes.push_back(static_cast<std::uint8_t>(static_cast<float>(classes) * 0.999f *
                                                            samples::chance(i % width / 2, i / width / 2, round)));
        const RegionMap regions = regions_of(map);
        const RegionBorders found = borders_of(regions, 0);
        std::vector<int> uses(found.borders.size(), 0);
        std::vector<double> area(regions.class_of.size(), 0), pixels(area.size(), 0);
        for (const std::uint32_t region : regions.region) ++pixels[region];
        for (const BorderRing& ring : found.rings) {
            std::vector<Point> points = found.points_of(ring);
            for (const auto& part : ring.parts) {
                ++uses[part.border];
                const Border& border = found.borders[part.border];
                EXPECT_EQ(part.backwards ? border.other : border.region, ring.region);
            }
            double twice = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Point a = points[i], b = points[(i + 1) % points.size()];
                twice += a.x * b.y - b.x * a.y;
            }
            area[ring.region] += twice / 2;  // holes run the other way
        }
        for (std::size_t i = 0; i < uses.size(); ++i) EXPECT_EQ(uses[i], found.borders[i].other < 0 ? 1 : 2);
        EXPECT_NEAR(std::accumulate(area.begin(), area.end(), 0.0), width * height, 1e-6) << "what one region loses another has";
    }
}

TEST(Regions, SmallOnesGoToTheNeighbourThatTheyShareMostBorderWith) {
    // A block of 10 mm in a corner that two grounds make: 60 of its 80 pixel sides are beside the right one.
    const Image image = painted(300, 200, [](int x, int y) {
        if (x >= 140 && x < 160 && y >= 90 && y < 110) return 0;
        return x < 140 ? 120 : 240;
    });
    const Drawing drawing = drawn(image, "smallest=15mm");
    ASSERT_EQ(drawing.strokes.size(), 1u);
    for (const Point& p : drawing.strokes[0].points) EXPECT_NEAR(p.x, 70, 0.6);
    EXPECT_EQ(drawn(image, "smallest=8mm").strokes.size(), 4u);
}

TEST(Regions, ThinPartsGoAndWideOnesKeepTheirBorders) {
    // A block with a thin rod: the rod goes, the block stays where it is.
    const Image image = painted(300, 200, [](int x, int y) {
        return (x >= 40 && x < 140 && y >= 50 && y < 150) || (x >= 140 && x < 260 && y >= 97 && y < 103) ? 30 : 230;
    });
    const Drawing drawing = drawn(image);
    ASSERT_EQ(drawing.areas.size(), 1u);
    double right = 0, left = 1e9;
    for (const Point& p : drawing.areas[0].rings[0]) {
        right = std::max(right, p.x);
        left = std::min(left, p.x);
    }
    EXPECT_NEAR(left, 20, 0.6);
    EXPECT_LT(right, 75);
    EXPECT_GT(right, 69);
}

// A tip that nearly touches a bar: what is between them is opened or closed, not left too narrow for the gap.
TEST(Regions, NecksAreOpenedOrClosed) {
    for (const int between : {2, 4, 6, 8, 20}) {
        const Image image = painted(360, 400, [between](int x, int y) {
            const bool diamond = std::abs(x - 180) + std::abs(y - 120) < 100, bar = y >= 220 + between && y < 300 + between;
            return diamond || bar ? 30 : 230;
        });
        Sheet sheet;
        sheet.paper = find_paper("a3", "test");
        sheet.medium = &find_medium("swell", "test");
        sheet.drawing_width = 180;
        const Page page = lay_out(drawn(image), sheet);
        const PageGeometry geometry(page);
        const Findings gaps = find_rule("gap")->check(geometry, 3.2);
        EXPECT_TRUE(gaps.places.empty()) << between << ": " << gaps.places[0].message.english();
    }
}

TEST(Regions, SmallestIsChosenFromTheSceneAndCanBeSet) {
    // 5 x 4 blocks of 25 mm and as much ground between them.
    const Image image = painted(560, 460, [](int x, int y) { return x % 110 >= 60 && y % 110 >= 60 ? 30 : 220; });
    const auto settled = [&](const std::string& settings, ChosenSetting& said) {
        Step step = parse_step("regions " + settings, "test", filters());
        said = step.filter->settle(image, step.settings);
        return step.settings.number("smallest");
    };
    ChosenSetting said;
    EXPECT_EQ(settled("most=30", said), std::ceil(6.4 + 2 * 4.4 + 2));
    EXPECT_EQ(said.setting, "smallest=18mm");
    EXPECT_EQ(said.why.english(), "less wide regions have no room for a texture");
    EXPECT_EQ(settled("most=30 clear=6mm", said), std::ceil(6.4 + 12 + 2)) << "a medium that needs more";
    EXPECT_GE(settled("most=7", said), 24);
    EXPECT_EQ(said.why.english(), "21 regions have room for a texture, 7 are enough");
    EXPECT_EQ(settled("smallest=30mm", said), 30);
    EXPECT_TRUE(said.empty());
    Step step = parse_step("regions most=30", "test", filters());
    const Artwork open = step.filter->apply(image, step.settings);
    step.filter->settle(image, step.settings);
    EXPECT_EQ(std::get<Drawing>(open).strokes.size(), std::get<Drawing>(step.filter->apply(image, step.settings)).strokes.size());
    EXPECT_EQ(std::get<Drawing>(open).strokes.size(), 20u);
}

TEST(Regions, APictureOfManyGreysIsCutAndOneOfOneIsBlank) {
    const Drawing ramp = drawn(painted(300, 60, [](int x, int) { return x * 255 / 300; }));
    EXPECT_LE(ramp.areas.size(), 6u);
    EXPECT_GE(ramp.areas.size(), 3u);
    std::set<int> used;
    for (const Area& area : ramp.areas) used.insert(area.texture);
    EXPECT_EQ(used.size(), ramp.areas.size()) << "each class has its own";
    const Drawing flat = drawn(painted(80, 60, [](int, int) { return 90; }));
    EXPECT_TRUE(flat.strokes.empty() && flat.areas.empty());
}

// Finer than regions need, and so large that the noise in it would be millions of regions.
TEST(Regions, ALargePictureIsLookedAtMoreCoarsely) {
    Image image = make_image(2400, 1800, 1, 0.05, 200);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            image.row(y)[x] =
                static_cast<std::uint8_t>((in_disc(x, y, 1200, 900, 600) ? 60 : 200) + ((x * 7 + y * 13) % 11 == 0 ? 40 : 0));
    const Drawing drawing = drawn(image);
    EXPECT_EQ(drawing.width, 120);
    ASSERT_EQ(drawing.strokes.size(), 1u);
    for (const Point& p : drawing.strokes[0].points) EXPECT_NEAR(distance(p, {60, 45}), 30, 0.5);
    EXPECT_LT(drawing.strokes[0].points.size(), 300u);
}

TEST(TextureChoice, NoOtherWayPartsNeighboursBetter) {
    for (int round = 0; round < 30; ++round) {
        const std::size_t classes = 2 + static_cast<std::size_t>(round) % 5;
        std::vector<std::vector<double>> border(classes, std::vector<double>(classes, 0));
        std::vector<double> grey;
        for (std::size_t a = 0; a < classes; ++a) {
            grey.push_back(255.0 * static_cast<double>(samples::chance(static_cast<int>(a), round, 1)));
            for (std::size_t b = 0; b < a; ++b)
                border[a][b] = border[b][a] =
                    100.0 * static_cast<double>(samples::chance(static_cast<int>(a), static_cast<int>(b), round));
        }
        const auto worth = [&](const std::vector<int>& textures) {
            double sum = 0;
            for (std::size_t a = 0; a < classes; ++a)
                for (std::size_t b = 0; b < a; ++b) sum += border[a][b] * difference(textures[a], textures[b]);
            return sum;
        };
        const std::vector<int> chosen = choose_textures(border, grey);
        EXPECT_EQ(std::set<int>(chosen.begin(), chosen.end()).size(), classes);
        for (std::size_t a = 0; a < classes; ++a) {
            EXPECT_TRUE(chosen[a] >= 0 && chosen[a] <= 5);
            // Nor does any exchange with another class, or with a texture that none has.
            for (int texture = 0; texture <= 5; ++texture) {
                std::vector<int> other = chosen;
                const auto has = std::find(other.begin(), other.end(), texture);
                if (has != other.end()) *has = other[a];
                other[a] = texture;
                EXPECT_LE(worth(other) * 0.98, worth(chosen) + 1e-9);
            }
        }
    }
    EXPECT_EQ(choose_textures({{0}}, {10}), std::vector<int>{0}) << "one class alone is blank";
    const auto two = choose_textures({{0, 50}, {50, 0}}, {30, 200});
    EXPECT_TRUE(two[1] == 0 && two[0] > 0) << "the lighter is blank";
}

}  // namespace
}  // namespace tactics::regions_test
