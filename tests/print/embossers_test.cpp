// SPDX-License-Identifier: Apache-2.0
// Every embosser: what its machine makes of the bytes is the page, dot by dot, in mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "print/embosser.h"
#include "print/format.h"
#include "print/free_dots.h"
#include "print/machines/sheet_feed.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/layout/lay_out.h"

namespace tactics::embossers_test {
namespace {

std::vector<const Format*> embossers() {
    std::vector<const Format*> all;
    for (const Format* format : formats())
        if (format->embosser != nullptr) all.push_back(format);
    return all;
}

// Each with its own braille and dots, as convert lays it out.
Sheet sheet_for(const Format& format, const Settings& settings) {
    Sheet sheet;
    sheet.paper = find_paper(format.paper, "test");
    sheet.medium = &find_medium(format.medium, "test");
    sheet.orientation = Orientation::portrait;
    fit_to_machine(sheet, format, settings);
    sheet.print_title = false;
    sheet.title = "A house, 12 m";
    return sheet;
}

std::vector<Point> circle(Point middle, double radius) {
    std::vector<Point> points;
    for (int i = 0; i < 120; ++i)
        points.push_back({middle.x + radius * std::cos(2 * std::numbers::pi * i / 120),
                          middle.y + radius * std::sin(2 * std::numbers::pi * i / 120)});
    return points;
}

// Lines level, upright, slanted and crossing, circles, a square, an area, a texture and words.
Drawing everything() {
    Drawing drawing;
    drawing.width = 160;
    drawing.height = 200;
    const auto line = [&](std::vector<Point> points, bool closed = false) {
        drawing.strokes.push_back({std::move(points), closed});
    };
    line({{5, 5}, {155, 5}});
    line({{5, 15}, {5, 190}});
    line({{15, 20}, {75, 47}});
    line({{15, 50}, {75, 17}});
    line(circle({115, 45}, 25), true);
    line({{20, 70}, {60, 70}, {60, 110}, {20, 110}}, true);
    line({{40, 70}, {40, 110}});
    drawing.areas.push_back({{circle({120, 100}, 14)}});
    Area textured{{{{20, 130}, {80, 130}, {80, 180}, {20, 180}}}};
    textured.texture = 2;
    drawing.areas.push_back(textured);
    drawing.names.push_back({{115, 45}, "pond", "test"});
    drawing.names.push_back({{120, 150}, "gate", "test"});
    return drawing;
}

Drawing at_random(unsigned seed) {
    std::mt19937 random(seed);
    const auto to = [&](double most) { return most * static_cast<double>(random() % 10'000) / 10'000; };
    Drawing drawing;
    drawing.width = 150;
    drawing.height = 180;
    for (int i = 0; i < 6; ++i) {
        Stroke stroke;
        Point p{to(150), to(180)};
        double way = to(6.28);
        for (int k = 0; k < 40; ++k) {
            stroke.points.push_back({std::clamp(p.x, 0.0, 150.0), std::clamp(p.y, 0.0, 180.0)});
            way += to(0.6) - 0.3;
            p = {p.x + 3 * std::cos(way), p.y + 3 * std::sin(way)};
        }
        drawing.strokes.push_back(std::move(stroke));
    }
    return drawing;
}

struct Steps {
    double across, down, least;  // mm: widest distances of two columns and rows of dots, least distance of two dots
};

Steps steps_of(const Page& page) {
    if (!page.bed) return {0, 0, kLeastBetweenDots - 0.08};  // of both dots, 0.05 mm in each direction
    if (page.bed->raster > 0) return {page.bed->raster, page.bed->raster, page.bed->raster - 0.01};
    return {page.cell.cell_pitch - page.cell.dot_pitch, page.cell.line_pitch - (page.bed->dots_down - 1) * page.cell.dot_pitch,
            page.cell.dot_pitch - 0.01};
}

bool inside(const Area& area, Point p) {
    bool in = false;
    for (const auto& ring : area.rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            if ((ring[i].y > p.y) != (ring[j].y > p.y) &&
                p.x < (ring[j].x - ring[i].x) * (p.y - ring[i].y) / (ring[j].y - ring[i].y) + ring[i].x)
                in = !in;
    return in;
}

// Points so close to each other along all lines that none between them matters.
std::vector<Point> samples_of(const std::vector<Point>& points, bool closed) {
    std::vector<Point> samples;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
        const Point a = points[i], b = points[(i + 1) % points.size()];
        const int count = 1 + static_cast<int>(distance(a, b) / 0.1);
        for (int k = 0; k <= count; ++k) samples.push_back({a.x + (b.x - a.x) * k / count, a.y + (b.y - a.y) * k / count});
    }
    if (samples.empty() && !points.empty()) samples.push_back(points[0]);
    return samples;
}

std::vector<Point> braille_dots(const Page& page) {
    std::vector<Point> dots;
    for (const BrailleLine& line : page.braille)
        for (const Point dot : dots_of(line, page.cell)) dots.push_back(dot);
    return dots;
}

void expect_same(const Page& page, const PunchedSheet& sheet, std::string_view name) {
    const Steps steps = steps_of(page);
    const bool cells = page.bed && page.bed->raster == 0;
    constexpr double kWaver = 0.15, kFloating = 0.05, kSlip = 1e-6;  // dot_chain.h; index_v4_floating.cpp
    const double across = page.bed ? (0.5 + kWaver) * steps.across + kSlip : kFloating,
                 down = page.bed ? (0.5 + kWaver) * steps.down + kSlip : kFloating;

    std::vector<Point> lines;
    std::vector<std::vector<Point>> each;
    for (const PageStroke& stroke : page.strokes) each.push_back(samples_of(stroke.points, stroke.closed));
    for (const Area& area : page.areas)
        for (const auto& ring : area.rings) each.push_back(samples_of(ring, true));
    for (const auto& one : each) lines.insert(lines.end(), one.begin(), one.end());
    const std::vector<Point> braille = braille_dots(page);

    std::size_t stray = 0, doubled = 0, missing = 0, lost = 0;
    for (const Point& dot : sheet.dots) {
        const auto is_near = [&](Point p, double dx, double dy) {
            return std::abs(p.x - dot.x) <= dx && std::abs(p.y - dot.y) <= dy;
        };
        const bool on_line =
            std::any_of(lines.begin(), lines.end(), [&](Point p) { return is_near(p, across + 0.05, down + 0.05); });
        const bool on_braille = std::any_of(braille.begin(), braille.end(), [&](Point p) { return is_near(p, 0.06, 0.06); });
        const bool in_area =
            std::any_of(page.areas.begin(), page.areas.end(), [&](const Area& area) { return inside(area, dot); });
        stray += on_line || on_braille || in_area ? 0 : 1;
        for (const Point& other : sheet.dots) doubled += &other > &dot && distance(other, dot) < steps.least ? 1 : 0;
    }
    // Along a line the next dot is a neighbour; one that stands for another's is within its width of it.
    const double reach_across = page.bed ? (1 + kWaver) * steps.across : 2 + kLeastBetweenDots,
                 reach_down = page.bed ? (1 + kWaver) * steps.down : reach_across;
    for (const auto& one : each)
        for (const Point p : one) {
            if (cells && (p.x < page.live.left || page.width - p.x < 12 || page.height - p.y < 16))
                continue;  // beside the last cell
            missing += std::any_of(sheet.dots.begin(), sheet.dots.end(),
                                   [&](const Point& dot) {
                                       return std::abs(p.x - dot.x) <= reach_across && std::abs(p.y - dot.y) <= reach_down;
                                   })
                           ? 0
                           : 1;
        }
    for (const Point p : braille)
        lost +=
            std::any_of(sheet.dots.begin(), sheet.dots.end(), [&](const Point& dot) { return distance(dot, p) < 0.06; }) ? 0 : 1;
    EXPECT_EQ(stray, 0u) << name;
    EXPECT_EQ(doubled, 0u) << name;
    EXPECT_EQ(missing, 0u) << name;
    EXPECT_EQ(lost, 0u) << name << " of " << braille.size();
}

TEST(Embossers, MachineMakesThePageOfTheBytes) {
    for (const Format* format : embossers()) {
        const Settings settings(format->options);
        const Page page = lay_out(everything(), sheet_for(*format, settings));
        ASSERT_EQ(page.names.size(), 2u) << format->name;
        const Punched punched = format->embosser->punch(format->encode(page, settings), settings);
        for (const Phrase& note : punched.notes) ADD_FAILURE() << format->name << ": " << note.english();
        ASSERT_EQ(punched.sheets.size(), 1u) << format->name;
        expect_same(page, punched.sheets[0], format->name);
        EXPECT_GT(punched.sheets[0].dots.size(), format->embosser->display != nullptr ? 200u : 300u) << format->name;
    }
}

TEST(Embossers, InEveryPitchAndSize) {
    const auto with = [](const Format& format, std::string_view name, std::string_view value) {
        Settings settings(format.options);
        settings.set(name, value, "test", format.name);
        return settings;
    };
    struct Trial {
        std::string_view embosser, option, value;
    };
    for (const auto& [embosser, option, value] : {Trial{"index-v3", "pitch", "1.6"},
                                                  {"index-v3", "pitch", "2.0"},
                                                  {"index-v3", "pitch", "2.5"},
                                                  {"index-v4", "pitch", "1.6"},
                                                  {"index-v4", "pitch", "2.0"},
                                                  {"index-v4-floating", "spacing", "1.6mm"},
                                                  {"index-v4-floating", "left", "3mm"},
                                                  {"generic", "line", "7.5mm"},
                                                  {"generic", "line", "13mm"},
                                                  {"generic", "dots", "8"},
                                                  {"enabling", "cell", "nls"},
                                                  {"enabling", "commands", "control"}}) {
        const Format& format = *find_format(embosser);
        const Settings settings = with(format, option, value);
        for (unsigned seed = 0; seed < 3; ++seed) {
            const Page page = lay_out(at_random(seed), sheet_for(format, settings));
            const Punched punched = format.embosser->punch(format.encode(page, settings), settings);
            EXPECT_TRUE(punched.notes.empty()) << embosser << ": " << punched.notes[0].english();
            ASSERT_EQ(punched.sheets.size(), 1u);
            expect_same(page, punched.sheets[0], embosser);
        }
    }
}

TEST(Embossers, PagesComeOutAsSheetsInTheirOrder) {
    for (const Format* format : embossers()) {
        if (format->encode_pages == nullptr) continue;
        const Settings settings(format->options);
        const Sheet sheet = sheet_for(*format, settings);
        const std::vector<Page> pages{lay_out(at_random(1), sheet), lay_out(everything(), sheet), lay_out(at_random(2), sheet)};
        const Punched all = format->embosser->punch(format->encode_pages(pages, settings), settings);
        ASSERT_EQ(all.sheets.size(), 3u) << format->name;
        for (std::size_t i = 0; i < pages.size(); ++i) {
            const Punched one = format->embosser->punch(format->encode(pages[i], settings), settings);
            ASSERT_EQ(one.sheets[0].dots.size(), all.sheets[i].dots.size()) << format->name;
            for (std::size_t k = 0; k < one.sheets[0].dots.size(); ++k)
                EXPECT_EQ(distance(one.sheets[0].dots[k], all.sheets[i].dots[k]), 0);
        }
    }
}

TEST(Embossers, EachSaysWhatItReliesOn) {
    for (const Format* format : embossers()) {
        EXPECT_FALSE(format->embosser->facts.empty()) << format->name;
        EXPECT_FALSE(format->embosser->models.empty()) << format->name;
        for (const ProtocolFact& fact : format->embosser->facts) {
            EXPECT_GT(fact.fact.size(), 10u) << format->name;
            EXPECT_GT(fact.source.size(), 5u) << format->name << ": " << fact.fact;
        }
    }
}

TEST(Embossers, RefuseASheetThatTheMachineDoesNotTake) {
    for (const Format* format : embossers()) {
        const Embosser& embosser = *format->embosser;
        const Settings settings(format->options);
        EXPECT_NO_THROW(check_sheet(embosser, settings, format->name, 210, 279));
        if (embosser.widest > 0) {
            EXPECT_THROW(check_sheet(embosser, settings, format->name, embosser.widest + 1, 100), Error);
            EXPECT_FALSE(takes_sheet(embosser, settings, embosser.widest + 1, 100));
        }
        if (embosser.longest > 0) {
            EXPECT_THROW(check_sheet(embosser, settings, format->name, 100, embosser.longest + 1), Error);
        }
    }
}

// All cells of each model stand on a sheet that it takes, but for the margins of that sheet nothing more.
TEST(Embossers, EnablingTakesTheSheetsOfEachModel) {
    const Format& format = *find_format("enabling");
    const auto takes = [&](std::string_view model, double width) {
        Settings settings(format.options);
        settings.set("model", model, "test", "enabling");
        return takes_sheet(*format.embosser, settings, width, 279);
    };
    for (const std::string_view model : choice_names(format.options[0])) {
        const bool wide = model == "juliet", small = model == "attache";
        EXPECT_EQ(takes(model, 381), wide) << model;  // 15 in
        EXPECT_EQ(takes(model, 286), !small) << model;
        EXPECT_TRUE(takes(model, 216)) << model;  // 8.5 in
        EXPECT_FALSE(takes(model, 382)) << model;
    }
    EXPECT_TRUE(takes("juliet", 56 * 6 + 2 * 6));
}

// What a machine is sent may come from anywhere, and be cut anywhere.
TEST(Embossers, MachinesBearAnyBytes) {
    std::mt19937 random(3);
    for (const Format* format : embossers()) {
        const Settings settings(format->options);
        const std::string whole = format->encode(lay_out(everything(), sheet_for(*format, settings)), settings);
        for (std::size_t cut = 0; cut < whole.size(); cut += 1 + whole.size() / 40)
            EXPECT_NO_THROW(format->embosser->punch(whole.substr(0, cut), settings));
        for (int trial = 0; trial < 40; ++trial) {
            std::string bytes = whole;
            for (int i = 0; i < 20; ++i) bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
            EXPECT_NO_THROW(format->embosser->punch(bytes, settings));
            for (char& c : bytes) c = static_cast<char>(random() % 256);
            const Punched punched = format->embosser->punch(bytes, settings);
            EXPECT_LE(punched.notes.size(), 21u);
        }
    }
}

TEST(Machines, KnowEveryLetterOfBraille) {
    std::set<char> letters;
    for (unsigned cell = 0; cell < 64; ++cell) {
        const char letter = brf_letter(static_cast<std::uint8_t>(cell));
        letters.insert(letter);
        EXPECT_EQ(cell_of_letter(static_cast<unsigned char>(letter)), cell) << letter;
    }
    EXPECT_EQ(letters.size(), 64u);
    EXPECT_EQ(cell_of_letter('a'), cell_of_letter('A'));
    EXPECT_FALSE(cell_of_letter(0x19));
    EXPECT_FALSE(cell_of_letter(0x80));
}

TEST(Machines, SheetsAsUnicodeBraille) {
    PunchedSheet dots;
    dots.dots = {{0, 0}, {2.5, 7.5}, {10, 10}};
    EXPECT_EQ(unicode_of(dots, 2.5), (std::vector<std::string>{"\u2881", "\u2800\u2800\u2801"}));
    PunchedSheet cells;
    cells.lines = {{1, 0, 0x3F, 0}, {}, {0}};
    EXPECT_EQ(unicode_of(cells, 2.5), (std::vector<std::string>{"\u2801\u2800\u283F"}));
    EXPECT_TRUE(unicode_of({}, 2.5).empty());
}

double to_line(Point p, const std::vector<Point>& samples) {
    double least = 1e9;
    for (const Point q : samples) least = std::min(least, distance(p, q));
    return least;
}

TEST(FreeDots, StandEvenlyOnTheLine) {
    for (const double spacing : {1.7, 2.0, 2.5}) {
        Page page;
        page.width = page.height = 200;
        page.strokes.push_back({circle({100, 100}, 40), true, 1.6});
        const auto samples = samples_of(page.strokes[0].points, true);
        const std::vector<Point> dots = free_dots(page, spacing);
        const double around = 240 * 40 * std::sin(std::numbers::pi / 120);
        EXPECT_EQ(dots.size(), static_cast<std::size_t>(std::lround(around / spacing)));
        for (const Point dot : dots) {
            EXPECT_LT(to_line(dot, samples), 0.06);
            std::vector<double> others;
            for (const Point other : dots) others.push_back(distance(dot, other));
            std::sort(others.begin(), others.end());
            EXPECT_NEAR(others[1], spacing, 0.03);  // its neighbours on both sides
            EXPECT_NEAR(others[2], spacing, 0.03);
        }
    }
}

TEST(FreeDots, CornersEndsAndCrossingsHaveOneDot) {
    Page page;
    page.width = page.height = 200;
    page.strokes.push_back({{{20, 20}, {61, 20}, {61, 63}, {20, 63}}, true, 1.6});
    page.strokes.push_back({{{10, 40}, {100, 47}}, false, 1.6});
    const std::vector<Point> dots = free_dots(page, 2);
    for (const Point must : {Point{20, 20}, {61, 20}, {61, 63}, {20, 63}, {10, 40}, {100, 47}})
        EXPECT_EQ(std::count_if(dots.begin(), dots.end(), [&](Point p) { return distance(p, must) < 1.59; }), 1) << must.x;
    for (const Point dot : dots)
        for (const Point other : dots) EXPECT_TRUE(distance(dot, other) == 0 || distance(dot, other) >= kLeastBetweenDots - 1e-9);
}

TEST(FreeDots, OfTwoLinesOnEachOtherOneIsRaised) {
    Page page;
    page.width = page.height = 100;
    page.strokes.push_back({{{10, 50}, {90, 50}}, false, 1.6});
    const std::size_t one = free_dots(page, 2).size();
    page.strokes.push_back({{{10, 50.4}, {90, 50.4}}, false, 1.6});
    page.strokes.push_back({{{90, 50}, {10, 50}}, false, 1.6});
    EXPECT_EQ(free_dots(page, 2).size(), one);
}

}  // namespace
}  // namespace tactics::embossers_test
