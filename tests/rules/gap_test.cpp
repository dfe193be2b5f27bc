// SPDX-License-Identifier: Apache-2.0
// What is a gap and what is not: bends, corners, meetings, holes, what lies between.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tactics/rules/ink_way.h"
#include "tactics/rules/narrow.h"
#include "tests/rules/pages.h"

namespace tactics::gap_test {
namespace {

using namespace tests;

constexpr double kLimit = 3.2;

std::size_t gaps_in(const Page& page) { return findings_of(page, "gap", kLimit).places.size(); }

// Two lines from one point, with that many degrees between them.
Page corner(double degrees, bool one_line, double reach = 60) {
    Page page = blank_page();
    const double half = degrees / 2 * std::numbers::pi / 180;
    const Point a{20 + reach * std::cos(half), 100 - reach * std::sin(half)},
        b{20 + reach * std::cos(half), 100 + reach * std::sin(half)};
    if (one_line) {
        add_line(page, {a, {20, 100}, b});
    } else {
        add_line(page, {a, {20, 100}});
        add_line(page, {{20, 100}, b});
    }
    return page;
}

TEST(Gap, IsMeasuredFromEdgeToEdge) {
    Page page = blank_page();
    add_line(page, {{20, 50}, {120, 50}}, 1);
    add_line(page, {{70, 60}, {70, 52.5 + 0.7}}, 3);
    const auto places = findings_of(page, "gap", kLimit).places;
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].measured, 3.2 - 0.5 - 1.5, 1e-9);
    EXPECT_EQ(places[0].message.english(), "a gap of 1.2 mm between two lines");
    EXPECT_NEAR(places[0].at.y + places[0].other->y, 50.5 + 51.7, 1e-9);
}

TEST(Gap, IsNotInACornerOrAMeeting) {
    for (const double degrees : {180.0, 120.0, 90.0, 60.0, 45.0, 35.0}) {
        EXPECT_EQ(gaps_in(corner(degrees, true)), 0u) << degrees;
        EXPECT_EQ(gaps_in(corner(degrees, false)), 0u) << degrees;
    }
    // A sliver that narrows to nothing is one.
    for (const double degrees : {15.0, 8.0, 3.0}) {
        EXPECT_EQ(gaps_in(corner(degrees, true)), 1u) << degrees;
        EXPECT_EQ(gaps_in(corner(degrees, false)), 1u) << degrees;
    }
}

TEST(Gap, IsNotAtACrossingOrBesideALineThatEndsOnAnother) {
    Page cross = blank_page();
    add_line(cross, {{20, 20}, {120, 120}});
    add_line(cross, {{20, 120}, {120, 20}});
    add_line(cross, {{70, 10}, {70, 130}});
    EXPECT_EQ(gaps_in(cross), 0u);
    // Two lines end on a third from both sides, a little apart: between their ends there is ink.
    Page offset = blank_page();
    add_line(offset, {{20, 100}, {180, 100}});
    add_line(offset, {{100, 20}, {100, 100}});
    add_line(offset, {{102, 100}, {102, 180}});
    EXPECT_EQ(gaps_in(offset), 0u);
    // From the same side they run beside each other.
    offset.strokes[2].points = {{102, 100}, {102, 20}};
    EXPECT_EQ(gaps_in(offset), 1u);
}

TEST(Gap, IsBetweenTwoPartsOfOneLine) {
    Page hairpin = blank_page();
    add_line(hairpin, {{20, 50}, {100, 50}, {100, 53}, {20, 53}});
    const auto places = findings_of(hairpin, "gap", kLimit).places;
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].measured, 2, 1e-9);
    EXPECT_EQ(places[0].message.english(), "a gap of 2 mm between two parts of a line");
    // A small ring is a dot with a hole; a bend that is as wide as it is deep is a bend.
    Page ring = blank_page();
    add_line(ring, circle({100, 100}, 1.5), 0.7, true);
    add_line(ring, {{20, 50}, {60, 50}, {60, 53}, {64, 53}, {64, 50}, {100, 50}});
    EXPECT_EQ(gaps_in(ring), 0u);
}

TEST(Gap, IsNotThroughInk) {
    Page page = blank_page();
    page.areas.push_back({{rectangle(50, 50, 2, 80)}});  // a line that another program drew as an area: its sides are 2 mm apart
    EXPECT_EQ(gaps_in(page), 0u);
    page.areas.push_back({{rectangle(54, 50, 20, 80), rectangle(58, 60, 2, 60)}});  // a slit in an area is a gap within it
    const auto places = findings_of(page, "gap", kLimit).places;
    ASSERT_EQ(places.size(), 2u);
    EXPECT_NEAR(places[0].measured, 2, 1e-9);
    EXPECT_EQ(places[0].message.english(), "a gap of 2 mm between two areas");
    EXPECT_EQ(places[1].message.english(), "a gap of 2 mm between two parts of an area's edge");
    // An area drawn with an outline of its own is one thing.
    Page outlined = blank_page();
    outlined.areas.push_back({{rectangle(50, 50, 30, 30)}});
    add_line(outlined, rectangle(50, 50, 30, 30), 1, true);
    add_line(outlined, {{20, 83}, {120, 83}});
    const auto under = findings_of(outlined, "gap", kLimit).places;
    ASSERT_EQ(under.size(), 1u);
    EXPECT_NEAR(under[0].measured, 2, 1e-9);
    EXPECT_EQ(under[0].message.english(), "a gap of 2 mm between two lines");
    // What is hidden in black is not felt.
    Page hidden = blank_page();
    hidden.areas.push_back({{rectangle(20, 20, 100, 100)}});
    add_line(hidden, {{30, 50}, {110, 50}});
    add_line(hidden, {{30, 53}, {110, 53}});
    EXPECT_EQ(gaps_in(hidden), 0u);
}

TEST(Gap, LooksNoFurtherThanTheNearestThing) {
    Page page = blank_page();
    for (const double y : {50.0, 52.0, 54.0}) add_line(page, {{20, y}, {120, y}}, 0.4);
    EXPECT_EQ(gaps_in(page), 2u);  // not between the first and the third, though they are 3.6 mm apart
    EXPECT_EQ(findings_of(page, "gap", 10).places.size(), 2u);
}

TEST(Gap, IsTheSameHoweverALineIsDivided) {
    Dice chance(11);
    std::size_t found = 0;
    for (int round = 0; round < 40; ++round) {
        Page page = blank_page(), divided = blank_page();
        const double way = chance.between(0, 3);
        for (int i = 0; i < 12; ++i) {
            // Side by side: how far from a meeting two lines still belong to it is told to the length of a piece only.
            const double reach = chance.between(10, 60);
            const Point a{chance.between(40, 160), chance.between(40, 160)};
            const Point b{a.x + reach * std::cos(way), a.y + reach * std::sin(way)};
            add_line(page, {a, b});
            std::vector<Point> points;
            for (int k = 0; k <= 40; ++k) points.push_back({a.x + (b.x - a.x) * k / 40, a.y + (b.y - a.y) * k / 40});
            add_line(divided, points);
        }
        const auto measures = [](const Page& of) {
            std::vector<double> all;
            for (const Finding& finding : findings_of(of, "gap", kLimit).places) all.push_back(finding.measured);
            std::sort(all.begin(), all.end());
            return all;
        };
        const auto one = measures(page), other = measures(divided);
        ASSERT_EQ(one.size(), other.size()) << round;
        for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-9) << round;
        found += one.size();
    }
    EXPECT_GT(found, 20u);
}

// The same places by comparing every piece with every other and asking every piece whether it lies between.
Findings naive_places(const PageGeometry& geometry, double limit) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Finding> best;
    InkWays ways(geometry);
    const auto along_line = [](Point from, Point to, double by) {
        const double length = distance(from, to);
        return Point{from.x + (to.x - from.x) / length * by, from.y + (to.y - from.y) / length * by};
    };
    for (std::size_t i = 0; i < geometry.pieces.size(); ++i)
        for (std::size_t j = i + 1; j < geometry.pieces.size(); ++j) {
            const Piece &p = geometry.pieces[i], &q = geometry.pieces[j];
            const double half = geometry.chains[p.chain].half_width, other_half = geometry.chains[q.chain].half_width;
            const Nearest near = nearest(p.line, q.line);
            const double gap = near.distance - half - other_half;
            if (gap <= kTouch || gap >= limit - kRounding) continue;
            const Segment between{along_line(near.one, near.other, half), along_line(near.other, near.one, other_half)};
            const auto black = [&](double t) {
                return geometry.black_area_at(
                    {between.a.x + t * (between.b.x - between.a.x), between.a.y + t * (between.b.y - between.a.y)});
            };
            if (black(0.02) || black(0.5) || black(0.98)) continue;
            if (ways.joined_within({p.chain, p.along + distance(p.line.a, near.one)},
                                   {q.chain, q.along + distance(q.line.a, near.other)}, 4 * near.distance))
                continue;
            const bool covered = std::any_of(geometry.pieces.begin(), geometry.pieces.end(), [&](const Piece& third) {
                if (third.chain == p.chain || third.chain == q.chain) return false;
                const double width = geometry.chains[third.chain].half_width, apart = nearest(between, third.line).distance;
                return width > 0 ? apart < width - 1e-6 : apart == 0;
            });
            if (covered) continue;
            const std::pair key{std::min(p.chain, q.chain), std::max(p.chain, q.chain)};
            const auto known = best.find(key);
            if (known == best.end() || gap < known->second.measured) best[key] = {gap, between.a, between.b, ""};
        }
    Findings all;
    for (const auto& [pair, finding] : best) all.places.push_back(finding);
    return all;
}

TEST(Gap, IsFoundByTheGridAsByComparingEverythingWithEverything) {
    Dice chance(5);
    std::size_t found = 0;
    for (int round = 0; round < 40; ++round) {
        Page page = blank_page(100, 100);
        for (int i = 0; i < 10; ++i)
            add_line(page, wandering_line(chance, {chance.between(0, 100), chance.between(0, 100)}, 2 + chance.below(8), 15),
                     chance.between(0.3, 4), chance.below(4) == 0);
        for (std::size_t i = 0; i < page.strokes.size(); ++i)
            if (page.strokes[i].points.size() < 3) page.strokes[i].closed = false;
        for (int i = 0; i < 3; ++i)
            page.areas.push_back({{starry_ring(chance, {chance.between(0, 100), chance.between(0, 100)}, 4, 20)}});
        const PageGeometry geometry(page);
        const auto measures = [](const Findings& findings) {
            std::vector<double> all;
            for (const Finding& f : findings.places) all.push_back(f.measured);
            std::sort(all.begin(), all.end());
            return all;
        };
        const auto expected = measures(naive_places(geometry, kLimit)),
                   got = measures(narrow_places(geometry, kLimit, Apart::edges));
        ASSERT_EQ(got.size(), expected.size()) << round;
        for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], expected[i], 1e-12) << round;
        found += got.size();
    }
    EXPECT_GT(found, 150u);
}

}  // namespace
}  // namespace tactics::gap_test
