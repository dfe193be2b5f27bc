// SPDX-License-Identifier: Apache-2.0
// Surfaces with one colour or a hatch, which get textures.
#include "filters/inked_fills.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

#include "filters/darken.h"
#include "filters/known_parts.h"
#include "tests/filters/pictures.h"

namespace tactics::inked_fills_test {
namespace {

// Bars 60 pixels wide, 15 mm, of each kind two; a black outline around each.
Image bars(const std::vector<std::function<int(int, int)>>& fills) {
    return pictures::drawn(100 * static_cast<int>(fills.size()), 200, [&](int x, int y) {
        const int u = x % 100, v = y;
        if (u < 20 || u >= 80 || v < 20 || v >= 180) return 255;
        if (u < 22 || u >= 78 || v < 22 || v >= 178) return 0;
        return fills[static_cast<std::size_t>(x / 100)](x, y);
    });
}

TEST(InkedFills, EachKindOfFillHasATextureOfItsOwn) {
    const auto hatch = [](int x, int y) { return (x + y) % 12 < 2 ? 0 : 255; };
    const auto other = [](int x, int y) { return (x - y + 400) % 12 < 2 ? 0 : 255; };
    const auto black = [](int, int) { return 0; };
    Image picture = bars({hatch, black, other, hatch, black, other});
    const KnownParts parts = take_known_parts(picture, ground_of(picture));
    ASSERT_EQ(parts.areas.size(), 6u);
    std::vector<int> textures(6);
    for (const Area& area : parts.areas) {
        double x = 0;
        for (const Point& p : area.rings.at(0)) x += p.x / static_cast<double>(area.rings[0].size());
        textures.at(static_cast<std::size_t>(x / pictures::kPixel / 100)) = area.texture;
    }
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(textures[i], textures[i + 3]) << i;
    EXPECT_EQ((std::set<int>{textures[0], textures[1], textures[2], 0}).size(), 4u);
    EXPECT_EQ(picture.row(100)[50], picture.row(101)[50]);  // no lines are left in it
}

// Bars on an axis, in a picture that is cut close below it.
TEST(InkedFills, AHatchEndsAtTheAxisThoughThePictureDoesSoon) {
    const auto hatch = [](int x, int y) { return (x + y) % 12 < 2 ? 0 : 255; };
    Image picture = pictures::drawn(340, 190, [&](int x, int y) {
        if (y >= 180) return x == 90 || x == 250 ? 0 : 255;  // ticks
        if (y >= 178) return 0;
        if (x % 160 < 20 || y < 90) return 255;
        if (x % 160 < 22 || x % 160 >= 158 || y < 92) return 0;
        return x % 160 < 90 ? hatch(x, y) : 0;
    });
    const Image before = picture;
    const std::vector<Area> areas = take_fills(picture, ground_of(picture));
    std::multiset<int> textures;
    for (const Area& area : areas) {
        textures.insert(area.texture);
        for (const Point& p : area.rings.at(0)) EXPECT_LT(p.y, 179.5 * pictures::kPixel);
    }
    ASSERT_EQ(areas.size(), 4u);
    for (const int texture : textures) EXPECT_EQ(textures.count(texture), 2u);
    for (int x = 0; x < picture.width; ++x)
        for (int y = 177; y < picture.height; ++y) ASSERT_EQ(picture.row(y)[x], before.row(y)[x]) << x << ' ' << y;
    for (const int x : {88, 89, 248}) EXPECT_NE(picture.row(130)[x], 255) << x;  // painted up to the black surface
}

TEST(InkedFills, OneFillOrMoreThanThereAreTexturesHaveNone) {
    Image one = bars({[](int, int) { return 120; }, [](int, int) { return 120; }});
    EXPECT_TRUE(take_known_parts(one, ground_of(one)).areas.empty());
    Image many = bars({[](int, int) { return 0; }, [](int, int) { return 40; }, [](int, int) { return 80; },
                       [](int, int) { return 120; }, [](int, int) { return 160; }, [](int, int) { return 200; }});
    EXPECT_TRUE(take_known_parts(many, ground_of(many)).areas.empty());
}

// Cut out at its frame, a drawing has no ground in it.
TEST(InkedFills, NoneIsTheGroundThatIsNotOfItsColour) {
    Image picture = pictures::drawn(400, 200, [](int x, int) { return x < 250 ? 90 : 160; });
    EXPECT_EQ(take_known_parts(picture, {{255, 255, 255}}).areas.size(), 2u);
}

}  // namespace
}  // namespace tactics::inked_fills_test
