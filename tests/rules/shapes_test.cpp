// SPDX-License-Identifier: Apache-2.0
// What the other rules count and what they leave alone.
#include <gtest/gtest.h>

#include "tactics/geometry/course.h"
#include "tactics/rules/coverage.h"
#include "tests/rules/pages.h"

namespace tactics::shapes_test {
namespace {

using namespace tests;

std::size_t count_of(const Page& page, const std::string& rule) { return findings_of(page, rule).places.size(); }

TEST(Crossings, AreLinesThatGoThroughEachOther) {
    Page page = blank_page();
    add_line(page, {{20, 50}, {120, 50}});
    add_line(page, {{70, 50}, {70, 120}});             // ends on it
    add_line(page, {{100, 50.6}, {100, 20}});          // ends in its ink
    add_line(page, {{30, 100}, {40, 50}, {50, 100}});  // touches it with a corner
    EXPECT_EQ(count_of(page, "crossings"), 0u);
    add_line(page, {{90, 20}, {90, 120}});
    const auto places = findings_of(page, "crossings").places;
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].at.x, 90, 1e-9);
    EXPECT_EQ(places[0].message.english(), "2 lines that cross at one place");
    EXPECT_EQ(findings_of(page, "crossings", 2).places.size(), 0u);
    Page loop = blank_page();
    add_line(loop, {{20, 50}, {120, 50}, {120, 90}, {70, 90}, {70, 20}});
    EXPECT_EQ(count_of(loop, "crossings"), 1u);
}

TEST(LineLength, CountsLinesThatTouchNothing) {
    Page page = blank_page();
    add_line(page, {{20, 50}, {26, 50}});
    EXPECT_EQ(count_of(page, "line-length"), 1u);
    add_line(page, {{26, 50}, {26, 90}});
    EXPECT_EQ(count_of(page, "line-length"), 0u);
    add_line(page, {{100, 100}, {100, 100}}, 2);  // a dot
    add_line(page, rectangle(150, 150, 3, 3), 1, true);
    EXPECT_EQ(count_of(page, "line-length"), 0u);
}

TEST(SideLength, MeasuresStraightSidesAndRoundShapesAcross) {
    Page page = blank_page();
    add_line(page, rectangle(20, 20, 60, 8), 1, true);
    ASSERT_EQ(count_of(page, "side-length"), 1u);
    EXPECT_NEAR(findings_of(page, "side-length").places[0].measured, 8, 1e-9);
    page.strokes[0].points = {{20, 20}, {33, 20}, {26.5, 31.26}};  // 13 mm
    EXPECT_EQ(count_of(page, "side-length"), 0u);
    page.strokes[0].points = circle({50, 50}, 6.4);  // its corners are near to each other, but it has no sides
    EXPECT_EQ(count_of(page, "side-length"), 0u);
    page.strokes[0].points = circle({50, 50}, 6.3);
    EXPECT_EQ(count_of(page, "side-length"), 1u);
    page.strokes[0].points = {{21, 20}, {79, 20}, {80, 21}, {80, 59}, {79, 60}, {21, 60}, {20, 59}, {20, 21}};  // cut corners
    EXPECT_EQ(count_of(page, "side-length"), 0u);
}

TEST(AreaSize, LeavesHolesAndHeadsOfArrowsAlone) {
    Page page = blank_page();
    page.areas.push_back({{rectangle(20, 20, 30, 30), rectangle(30, 30, 4, 4)}});
    EXPECT_EQ(count_of(page, "area-size"), 0u);
    page.areas.push_back({{{{100, 100}, {104, 98}, {104, 102}}}});
    EXPECT_EQ(count_of(page, "area-size"), 1u);
    add_line(page, {{104, 100}, {150, 100}});
    EXPECT_EQ(count_of(page, "area-size"), 0u);
}

TEST(Detail, FindsSpecksAndPinholes) {
    Page page = blank_page();
    page.areas.push_back({{rectangle(20, 20, 30, 30), rectangle(30, 30, 0.5, 0.5)}});
    auto places = findings_of(page, "detail").places;
    ASSERT_EQ(places.size(), 1u);
    EXPECT_EQ(places[0].message.english(), "a hole 0.71 mm across");
    add_line(page, {{100, 100}, {100.2, 100}}, 0.3);
    places = findings_of(page, "detail").places;
    ASSERT_EQ(places.size(), 2u);
    EXPECT_EQ(places[1].message.english(), "a speck 0.5 mm across");
}

TEST(BrailleClearance, SeesLinesAreasAndPictures) {
    Page page = blank_page();
    page.braille.push_back({{50, 50}, {0x01, 0, 0x01, 0, 0}});
    const auto places = [&] { return findings_of(page, "braille-clearance").places; };
    EXPECT_TRUE(places().empty());
    // Behind the last cell with a dot there is no braille; between two there is.
    add_line(page, {{80, 20}, {80, 80}});
    EXPECT_TRUE(places().empty());
    page.strokes[0].points = {{57, 20}, {57, 48}};
    ASSERT_EQ(places().size(), 1u);
    EXPECT_NEAR(places()[0].measured, 50 - 0.8 - 48 - 0.5, 1e-9);
    page.strokes.clear();
    page.areas.push_back({{rectangle(20, 20, 100, 100)}});
    ASSERT_EQ(places().size(), 1u);
    EXPECT_EQ(places()[0].message.english(), "an area in braille");
    page.areas.clear();
    page.picture = Bitmap{8, 8, {20, 20, 16, 28}, std::vector<std::uint8_t>(8, 0)};
    EXPECT_TRUE(places().empty());
    page.picture->place = {40, 40, 16, 8};
    page.picture->bits[7] = 0x10;  // one black pixel: 46 to 48 across, 47 to 48 down
    ASSERT_EQ(places().size(), 1u);
    EXPECT_NEAR(places()[0].measured, std::hypot(49.2 - 48, 49.2 - 48), 1e-9);
    EXPECT_EQ(places()[0].at.x, 46);
}

// Black by asking a million places.
double sampled_percent(const Page& page) {
    const PageGeometry geometry(page);
    constexpr int kSteps = 1000;
    int black = 0;
    for (int y = 0; y < kSteps; ++y)
        for (int x = 0; x < kSteps; ++x) {
            const Point p{(x + 0.5) * page.width / kSteps, (y + 0.5) * page.height / kSteps};
            bool in = geometry.black_area_at(p);
            for (std::size_t i = 0; i < page.strokes.size() && !in; ++i) {
                const PageStroke& stroke = page.strokes[i];
                for (std::size_t k = 1; k < stroke.points.size() && !in; ++k)
                    in = distance(p, nearest_on({stroke.points[k - 1], stroke.points[k]}, p)) <= stroke.width / 2;
            }
            black += in ? 1 : 0;
        }
    return 100.0 * black / kSteps / kSteps;
}

TEST(Ink, IsTheShareThatAMillionPlacesSay) {
    Dice chance(9);
    for (int round = 0; round < 3; ++round) {
        Page page = blank_page(100, 100);
        for (int i = 0; i < 8; ++i)
            add_line(page, wandering_line(chance, {chance.between(-10, 110), chance.between(-10, 110)}, 3, 40),
                     chance.between(0.5, 8));
        for (int i = 0; i < 4; ++i)
            page.areas.push_back({{starry_ring(chance, {chance.between(0, 100), chance.between(0, 100)}, 5, 40)}});
        const auto percent = percent_black(PageGeometry(page));
        ASSERT_TRUE(percent);
        EXPECT_NEAR(*percent, sampled_percent(page), 0.15);
    }
}

// A page whose lines and areas could not be too much even beside each other is not measured: that must not be told of one that
// is.
TEST(Ink, BeyondALimitIsWhatIsMeasuredBeyondIt) {
    Dice chance(12);
    int beyond = 0, within = 0;
    for (int round = 0; round < 12; ++round) {
        Page page = blank_page(100, 100);
        for (int i = 0; i < 1 + round; ++i) {
            const double x = chance.between(0, 100), y = chance.between(0, 100);
            if (round % 3 == 0) page.areas.push_back({{{{x, y}, {x + 10, y}, {x + 10, y + 10}, {x, y + 10}}}});
            add_line(page, {{x, y}, {x + (round % 2 == 0 ? 0 : 20), y + 9}}, 0.3 * (1 + round));
        }
        if (round == 5) page.braille.push_back({{20, 20}, std::vector<std::uint8_t>(10, 0x3f)});
        const PageGeometry geometry(page);
        const double percent = percent_black(geometry).value();
        for (const double limit : {0.0, percent * 0.5, percent * 0.99 - 0.01, percent * 1.01, percent * 1.5, percent * 4}) {
            if (limit < 0) continue;
            const bool told = !ink_beyond(geometry, limit).places.empty();
            EXPECT_EQ(told, percent > limit + kRounding) << round << " " << percent << " " << limit;
            ++(told ? beyond : within);
        }
    }
    EXPECT_GT(beyond, 20);
    EXPECT_GT(within, 20);
}

// Few of the areas beside a place are examined; the result equals that of examining all.
TEST(BlackArea, IsWhatAskingEachAreaSays) {
    Dice chance(4);
    Page page = blank_page(200, 200);
    for (int i = 0; i < 300; ++i)
        page.areas.push_back({{starry_ring(chance, {chance.between(-10, 210), chance.between(-10, 210)}, 1,
                                           chance.between(2, i % 50 == 0 ? 90 : 9))}});
    const PageGeometry geometry(page);
    int black = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Point p{chance.between(-20, 220), chance.between(0, 200)};
        bool expected = false;
        for (const Area& area : page.areas) {
            bool inside = false;
            for (const auto& ring : area.rings)
                for (std::size_t k = 0; k < ring.size(); ++k) inside ^= ray_meets(p, ring[k], ring[(k + 1) % ring.size()]);
            expected = expected || inside;
        }
        ASSERT_EQ(geometry.black_area_at(p), expected) << p.x << ' ' << p.y;
        black += expected ? 1 : 0;
    }
    EXPECT_GT(black, 2000);
    EXPECT_LT(black, 18'000);
}

TEST(Ink, CountsPicturesAndBraille) {
    Page page = blank_page(100, 100);
    page.picture = Bitmap{16, 2, {0, 0, 100, 50}, {0xf0, 0x00, 0x00, 0xff}};
    EXPECT_NEAR(*percent_black(PageGeometry(page)), 0.5 * 12 / 32 * 100, 0.05);
    page.picture.reset();
    page.braille.push_back({{20, 20}, std::vector<std::uint8_t>(10, 0x3f)});
    EXPECT_NEAR(*percent_black(PageGeometry(page)), 60 * std::numbers::pi * 0.64 / 100, 0.02);
}

}  // namespace
}  // namespace tactics::shapes_test
