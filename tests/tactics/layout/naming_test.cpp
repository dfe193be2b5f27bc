// SPDX-License-Identifier: Apache-2.0
// Names beside their things: clear of everything, found by a finger, none lost.
#include "tactics/layout/naming.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "tactics/error.h"
#include "tactics/geometry/box.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/room.h"
#include "tactics/rules/rule.h"

namespace tactics::naming_test {
namespace {

constexpr double kGap = 3.2;

Sheet sheet() {
    Sheet sheet;
    sheet.paper = find_paper("a4", "test");
    sheet.medium = &find_medium("swell", "test");
    return sheet;
}

double to_segment(Point p, Point a, Point b) {
    const double length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    const double t = length > 0 ? std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length, 0.0, 1.0) : 0;
    return distance(p, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}

double to_stroke(Point p, const PageStroke& stroke) {
    double least = 1e9;
    for (std::size_t i = 0; i + 1 < stroke.points.size() + (stroke.closed ? 1 : 0); ++i)
        least = std::min(least, to_segment(p, stroke.points[i], stroke.points[(i + 1) % stroke.points.size()]));
    return least - stroke.width / 2;
}

double between(const Rect& a, const Rect& b) {
    return std::hypot(std::max({a.left - b.left - b.width, b.left - a.left - a.width, 0.0}),
                      std::max({a.top - b.top - b.height, b.top - a.top - a.height, 0.0}));
}

// A drawing as wide as the live area of A4, of long curved lines, with names on some of their points; a key has room below.
Drawing scene(std::uint32_t seed, int lines, int names) {
    std::mt19937 random(seed);
    const auto below = [&](double most) { return static_cast<double>(random() % 10000) * most / 10000; };
    Drawing drawing{270, 180, {}, {}, {}};
    for (int i = 0; i < lines; ++i) {
        Stroke stroke{{{below(270), below(100)}}, i % 3 == 0};
        double angle = below(6.28);
        const double turn = below(0.2) - 0.1;
        for (int k = 0; k < 30; ++k, angle += turn)
            stroke.points.push_back({std::clamp(stroke.points.back().x + 3 * std::cos(angle), 0.0, 270.0),
                                     std::clamp(stroke.points.back().y + 3 * std::sin(angle), 0.0, 100.0)});
        drawing.strokes.push_back(stroke);
    }
    const std::string words[] = {"Park", "River Ember", "Station Road", "x", "Old Bridge Road", "church", "7 hills"};
    for (int i = 0; i < names; ++i)
        drawing.names.push_back(
            {drawing.strokes[static_cast<std::size_t>(i % lines)].points[static_cast<std::size_t>(random() % 30)],
             words[i % 7] + " " + std::to_string(i), "--label " + std::to_string(i + 1)});
    return drawing;
}

struct Dots {
    Rect extent;
    std::vector<Point> centres;
};

Dots dots_in(const Page& page, const Rect& place) {
    Dots dots{place, {}};
    for (const BrailleLine& line : page.braille)
        for (const Point& dot : dots_of(line, page.cell))
            if (dot.x >= place.left && dot.x <= place.left + place.width && dot.y >= place.top &&
                dot.y <= place.top + place.height)
                dots.centres.push_back(dot);
    return dots;
}

TEST(Naming, EveryNameStandsOnceAndClearOfEverything) {
    std::size_t beside = 0, led = 0, keyed = 0, refused = 0;
    for (std::uint32_t seed = 1; seed <= 30; ++seed) {
        const Drawing drawing = scene(seed, 4 + static_cast<int>(seed % 12), 3 + static_cast<int>(seed % 9));
        Page page;
        try {
            page = lay_out(drawing, sheet());
        } catch (const Error&) {  // said so, which is as good, if it is seldom
            ++refused;
            continue;
        }
        ASSERT_EQ(page.names.size(), drawing.names.size());
        std::multiset<std::string> wanted, set;
        for (const Name& name : drawing.names) wanted.insert(name.text);
        for (const PageName& name : page.names) set.insert(name.text);
        EXPECT_EQ(set, wanted);
        const std::size_t own = drawing.strokes.size();
        led += page.strokes.size() - own;
        for (const PageName& name : page.names) {
            keyed += name.key.empty() ? 0 : 1;
            beside += name.key.empty() ? 1 : 0;
            EXPECT_GE(name.place.left, page.live.left);
            EXPECT_LE(name.place.top + name.place.height, page.live.top + page.live.height + 1e-9);
            const Dots dots = dots_in(page, name.place);
            EXPECT_FALSE(dots.centres.empty());
            for (const Point& dot : dots.centres) {
                for (std::size_t i = 0; i < own; ++i)
                    EXPECT_GE(to_stroke(dot, page.strokes[i]) - page.braille_dot / 2, kGap - 1e-9) << seed << ' ' << name.text;
                // A lead line may come as near as two dots to its own words, to no others.
                for (std::size_t i = own; i < page.strokes.size(); ++i)
                    EXPECT_GE(to_stroke(dot, page.strokes[i]) - page.braille_dot / 2, 2.5 - 0.35 - 1e-9)
                        << seed << ' ' << name.text;
            }
            for (const PageName& other : page.names)
                EXPECT_TRUE(&other == &name || between(name.place, other.place) >= kGap - 1e-9);
            const Rect thing{name.thing.x, name.thing.y, 0, 0};
            EXPECT_LE(between(name.place, thing), 38 + 2.5 + 1e-9);
        }
    }
    // All three ways were seen.
    EXPECT_GT(beside, 50u);
    EXPECT_GT(led, 10u);
    EXPECT_GT(keyed, 0u);
    EXPECT_LE(refused, 6u);
}

TEST(Naming, LeadLinesMeetNoOtherLineIfTheyCan) {
    // A thing in a narrow ring that has room for no words and is no shape of its own: out of it every way crosses the ring, so it
    // is crossed once.
    Drawing drawing{270, 180, {}, {}, {}};
    Stroke ring{{}, false};
    for (int i = 0; i < 60; ++i) ring.points.push_back({135 + 6 * std::cos(i * 0.10472), 90 + 6 * std::sin(i * 0.10472)});
    drawing.strokes = {ring, Stroke{{{10, 90}, {100, 90}}}};
    drawing.names = {{{135, 90}, "well"}, {{60, 90}, "road"}};
    const Page page = lay_out(drawing, sheet());
    ASSERT_EQ(page.names.size(), 2u);
    EXPECT_EQ(page.strokes.size(), 3u);
}

TEST(Naming, WordsThatABoxHasNoRoomForStandBesideIt) {
    Drawing drawing{270, 180, {Stroke{{{120, 84}, {150, 84}, {150, 96}, {120, 96}}, true}}, {}, {}};
    drawing.names = {{{135, 90}, "Evaporation of water"}};
    const Page page = lay_out(drawing, sheet());
    const PageName& name = page.names.at(0);
    EXPECT_EQ(name.key, "");
    EXPECT_EQ(page.strokes.size(), 1u) << "no lead is needed";
    const Box box = box_of(page.strokes[0].points);
    const double away = between(name.place, {box.left, box.top, box.width(), box.height()});
    EXPECT_GE(away, kGap - 1e-9);
    EXPECT_LE(away, 6.4 + 1e-9);
    // What is in a corner of it is something else than the box.
    drawing.names = {{{147, 94}, "Evaporation of water"}};
    EXPECT_GT(lay_out(drawing, sheet()).strokes.size(), 1u);
}

TEST(Naming, NoLineLeadsIntoTheMargin) {
    Drawing drawing{271.6, 184.6, {}, {}, {}};
    for (double y = 0; y <= 184; y += 5) drawing.strokes.push_back(Stroke{{{0, y}, {200, y}}});
    for (int i = 0; i < 8; ++i) drawing.names.push_back({{205, 190}, "Hours", "print", 0, true});
    const Page page = lay_out(drawing, sheet());
    EXPECT_TRUE(std::none_of(page.strokes.begin(), page.strokes.end(), [](const PageStroke& s) { return s.role == Role::lead; }));
    EXPECT_FALSE(page.left_out.empty()) << "which is told";
}

TEST(Naming, OnAnEmptyPlaceTheWordsStandAroundTheThing) {
    Drawing drawing{270, 180, {Stroke{{{0, 0}, {270, 0}}}}, {}, {}};
    drawing.names = {{{135, 90}, "sea"}};
    const Page page = lay_out(drawing, sheet());
    const PageName& name = page.names.at(0);
    EXPECT_NEAR(name.place.middle().x, name.thing.x, 1);
    EXPECT_NEAR(name.place.middle().y, name.thing.y, 1);
    EXPECT_EQ(page.strokes.size(), 1u);
}

// Two letters of the words, one of them with dot 3 or 6; the key has them in cell 1 and the words from cell 6.
TEST(Naming, WhatHasNoRoomGetsTwoLettersAndAKey) {
    Drawing drawing{270, 180, {}, {}, {}};
    for (int i = 0; i < 12; ++i) drawing.strokes.push_back(Stroke{{{10.0 + 22 * i, 0}, {10.0 + 22 * i, 75}}});
    for (int i = 0; i < 9; ++i) drawing.names.push_back({{21.0 + 22 * i, 20.0 + 5 * i}, "Market Street " + std::to_string(i)});
    const Page page = lay_out(drawing, sheet());
    std::set<std::string> keys;
    for (const PageName& name : page.names)
        if (!name.key.empty()) keys.insert(name.key);
    EXPECT_GE(keys.size(), 5u);
    EXPECT_TRUE(keys.contains("ms"));
    std::set<std::pair<int, int>> entries, letters;
    for (const BrailleLine& line : page.braille) {
        if (line.cells.size() == 2) letters.insert({line.cells[0], line.cells[1]});
        if (line.cells.size() <= 5 || line.cells[2] != 0) continue;
        EXPECT_EQ(line.cells[3] | line.cells[4], 0);
        EXPECT_NE(line.cells[5], 0);
        entries.insert({line.cells[0], line.cells[1]});
    }
    EXPECT_EQ(entries, letters);
    EXPECT_EQ(entries.size(), keys.size());
    for (const auto& pair : entries) EXPECT_NE((pair.first | pair.second) & 0b100100, 0);
}

TEST(Naming, WhatCannotBeSetIsTold) {
    Drawing drawing{270, 180, {}, {}, {}};
    for (int i = 0; i < 60; ++i) drawing.strokes.push_back(Stroke{{{0, 3.0 * i}, {270, 3.0 * i}}});
    drawing.names = {{{100, 90}, "Park", "map.labels:3"}};
    try {
        lay_out(drawing, sheet());
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::usage);
        EXPECT_TRUE(std::string(error.what()).starts_with("map.labels:3: there is no room")) << error.what();
    }
    drawing.strokes.clear();
    drawing.names[0].text = "\xE6\x97\xA5\xE6\x9C\xAC";  // no letters of that table
    EXPECT_THROW(lay_out(drawing, sheet()), Error);
    drawing.names[0].text = "  ";
    EXPECT_TRUE(lay_out(drawing, sheet()).names.empty());
}

// The naive twin: what is said to be free is free of every point on every line.
TEST(Room, FreeIsFree) {
    const Page page = lay_out(scene(77, 14, 0), sheet());
    const Room room(page, kGap);
    std::mt19937 random(3);
    std::size_t free = 0, near = 0;
    for (int i = 0; i < 4000; ++i) {
        const Rect rect{static_cast<double>(random() % 2900) / 10, static_cast<double>(random() % 2000) / 10, 12, 6};
        double least = 1e9;
        for (const PageStroke& stroke : page.strokes)
            for (std::size_t k = 0; k + 1 < stroke.points.size() + (stroke.closed ? 1 : 0); ++k) {
                const Point a = stroke.points[k], b = stroke.points[(k + 1) % stroke.points.size()];
                for (int t = 0; t <= 10; ++t) {
                    const Rect point{a.x + t * (b.x - a.x) / 10, a.y + t * (b.y - a.y) / 10, 0, 0};
                    least = std::min(least, between(rect, point) - stroke.width / 2);
                }
            }
        const double square = 0.5;
        const bool inside = rect.left >= page.live.left + square && rect.top >= page.live.top + square &&
                            rect.left + rect.width + square <= page.live.left + page.live.width &&
                            rect.top + rect.height + square <= page.live.top + page.live.height;
        if (room.is_free(rect)) {
            ++free;
            EXPECT_GE(least, kGap - 1e-9);
        } else if (inside) {
            ++near;
            EXPECT_LE(least, kGap + 2) << rect.left << ' ' << rect.top;  // not much more is kept away than asked
        }
    }
    EXPECT_GT(free, 100u);
    EXPECT_GT(near, 100u);
}

TEST(Room, TheInsideOfAnAreaIsNotFree) {
    Drawing drawing{
        270, 180, {}, {Area{{{{50, 50}, {200, 50}, {200, 150}, {50, 150}}, {{100, 80}, {150, 80}, {150, 120}, {100, 120}}}}}, {}};
    const Page page = lay_out(drawing, sheet());
    const Room room(page, kGap);
    const double x = page.live.left + (page.live.width - 270) / 2, y = page.live.top;
    const auto free = [&](double left, double top) { return room.is_free({x + left, y + top, 10, 10}); };
    EXPECT_FALSE(free(60, 60));
    EXPECT_FALSE(free(170, 130));
    EXPECT_TRUE(free(120, 95));  // a hole
    EXPECT_TRUE(free(10, 10));
}

// What is taken one by one leaves the same room as a page that has it from the beginning, on a page of many rows, too.
TEST(Room, WhatIsTakenIsAsIfItHadBeenThere) {
    Page page;
    page.width = 300;
    page.height = 900;
    page.live = {5, 5, 290, 890};
    Page full = page;
    Room room(page, kGap);
    std::mt19937 random(5);
    const auto at = [&](unsigned most) { return static_cast<double>(random() % most); };
    for (int i = 0; i < 40; ++i) {
        const Point from{at(300), at(900)}, to{from.x + at(40) - 20, from.y + at(40) - 20};
        room.take(from, to, 0.5);
        full.strokes.push_back({{from, to}, false, 0.5});
    }
    const Room whole(full, kGap);
    std::size_t free = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Rect rect{at(290), at(880), 1 + at(30), 1 + at(20)};
        if (room.is_free(rect)) {
            ++free;
            // A square more may be kept away than is needed.
            const Rect inner{rect.left + 1, rect.top + 1, std::max(0.0, rect.width - 2), std::max(0.0, rect.height - 2)};
            ASSERT_TRUE(whole.is_free(inner)) << rect.left << ' ' << rect.top;
        } else {
            const Rect outer{rect.left - 1, rect.top - 1, rect.width + 2, rect.height + 2};
            ASSERT_FALSE(whole.is_free(outer)) << rect.left << ' ' << rect.top;
        }
    }
    EXPECT_GT(free, 1000u);
}

// The rules for words on a drawing that name themselves hard are kept, those for lead lines and keys, too; only that a lead
// line may be short is left to a person.
TEST(Naming, KeepsTheRules) {
    std::size_t leads = 0, keyed = 0;
    for (std::uint32_t seed = 1; seed < 25; ++seed) {
        Page page;
        try {
            page = lay_out(scene(seed, 6, 12), sheet());
        } catch (const Error&) {
            continue;  // no room even for two letters
        }
        // Lines of the scene are close to each other already; lead lines must not add to that.
        Drawing unnamed = scene(seed, 6, 12);
        unnamed.names.clear();
        const Rule& gap = *find_rule("gap");
        const Demand apart{&gap, gap.limit.fallback};
        EXPECT_LE(check_page(page, {&apart, 1})[0].findings.places.size(),
                  check_page(lay_out(unnamed, sheet()), {&apart, 1})[0].findings.places.size())
            << "seed " << seed;
        for (const PageStroke& stroke : page.strokes) leads += stroke.role == Role::lead ? 1 : 0;
        for (const PageName& name : page.names) keyed += name.key.empty() ? 0 : 1;
        for (const std::string_view rule :
             {"lead-width", "lead-length", "lead-arrows", "key-letters", "key-dots", "key-words", "braille-clearance"}) {
            const Rule& asked = *find_rule(rule);
            const Demand demand{&asked, asked.limit.fallback};
            const Findings findings = check_page(page, {&demand, 1})[0].findings;
            EXPECT_TRUE(findings.places.empty()) << rule << ": " << findings.places[0].message.english();
        }
    }
    EXPECT_GT(leads, 10u);
    EXPECT_GT(keyed, 10u);
}

// On a page of several sheets no word is cut: it can be read on one of them, with its place.
TEST(Naming, WordsStandOnOneSheetAsAWhole) {
    std::size_t named = 0;
    for (std::uint32_t seed = 1; seed < 12; ++seed) {
        Sheet large = sheet();
        large.paper = find_paper("a5", "test");
        large.tiles = {2, 2};
        const Drawing drawing = scene(seed, 5, 16);
        Pages pages;
        try {
            pages = pages_of(drawing, large);
        } catch (const Error&) {
            continue;  // no room even for two letters
        }
        for (const PageName& name : pages.whole().names) {
            const auto whole = std::find_if(pages.all.begin(), pages.all.end(), [&](const Page& page) {
                return std::any_of(page.names.begin(), page.names.end(), [&](const PageName& other) {
                    if (other.text != name.text || std::abs(other.place.width - name.place.width) > 1e-9) return false;
                    // All of its cells are there.
                    return std::any_of(page.braille.begin(), page.braille.end(), [&](const BrailleLine& line) {
                        return std::abs(line.first_dot.x - other.place.left - page.braille_dot / 2) < 1e-6 &&
                               line.first_dot.y > other.place.top && line.first_dot.y < other.place.top + other.place.height &&
                               std::abs(extent_of(line, page.cell, page.braille_dot).width - other.place.width) < 1e-6;
                    });
                });
            });
            EXPECT_NE(whole, pages.all.end()) << name.text << ", seed " << seed;
            ++named;
        }
    }
    EXPECT_GT(named, 30u);
}

// 100,000 lines: what can be named is named in the room that is left, and what cannot is told.
TEST(Naming, ComesToAnEndOnAVeryBusyDrawing) {
    std::mt19937 random(9);
    const auto below = [&](double most) { return static_cast<double>(random() % 10000) * most / 10000; };
    Drawing drawing{270, 180, {}, {}, {}};
    for (int i = 0; i < 100'000; ++i) {
        const Point from{below(260), below(90)};
        drawing.strokes.push_back({{from, {from.x + 2, from.y + 1.5}}});
    }
    drawing.names = {{{30, 150}, "in the free part", "--label 1"}, {{90, 97}, "beside the lines", "--label 2"}};
    const Page page = lay_out(drawing, sheet());
    EXPECT_EQ(page.names.size(), 2u);
    drawing.names.push_back({{130, 40}, "in the middle of them", "--label 3"});
    try {
        lay_out(drawing, sheet());
        ADD_FAILURE() << "there is no room";
    } catch (const Error& error) {
        EXPECT_TRUE(
            std::string(error.what()).starts_with("--label 3: there is no room for the words and even for two letters of"))
            << error.what();
    }
}

// The page lists the optional names that it left out; the others are placed as if these did not exist.
TEST(Naming, LeavesOutAndTellsOptionalNamesWithoutRoom) {
    Drawing drawing;
    drawing.width = drawing.height = 40;
    drawing.strokes.push_back({{{20, 0}, {20, 40}}});
    for (int i = 0; i < 40; ++i) drawing.names.push_back({{20, 20}, "name " + std::to_string(i), "test", 0, true});
    Sheet sheet;
    sheet.paper = {"", "", 60, 60};
    sheet.medium = &find_medium("swell", "test");
    sheet.margin = 5;
    const Page page = lay_out(drawing, sheet);
    EXPECT_GT(page.left_out.size(), 20u);
    EXPECT_EQ(page.left_out.size() + page.names.size(), 40u);
    for (Name& name : drawing.names) name.optional = false;
    EXPECT_THROW(lay_out(drawing, sheet), Error);
}

}  // namespace
}  // namespace tactics::naming_test
