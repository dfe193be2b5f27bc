// SPDX-License-Identifier: Apache-2.0
// A page that we wrote as SVG is read back as the same page, and as what a person made of it.
#include "tactics/readers/svg/own_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>
#include <tuple>

#include "print/format.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tests/cli/tool.h"
#include "tests/print/hard_pages.h"

namespace tactics::own_page_test {
namespace {

std::string svg_of(const Page& page) {
    const Format& svg = *find_format("svg");
    return svg.encode(page, Settings(svg.options));
}

Page read(const std::string& svg) {
    auto own = read_own_page(svg, "page.svg");
    if (!own) throw std::runtime_error("not one of ours");
    return std::move(own->page);
}

// Everything of a page, spelled out exactly.
class Spelling {
public:
    explicit Spelling(const Page& page) {
        add("size", page.width, page.height, page.live, page.drawing, page.braille_dot, page.is_key);
        add("cell", page.cell.dot_pitch, page.cell.cell_pitch, page.cell.line_pitch, page.cell.dot);
        if (page.bed) add("bed", page.bed->first, page.bed->raster, page.bed->dots_down);
        add("told", page.title, page.caption, page.braille_table, page.description, page.language, page.medium);
        if (page.scale) add("scale", page.scale->text, page.scale->length, page.scale->real, page.scale->place);
        for (const PageStroke& stroke : page.strokes)
            add("stroke", static_cast<int>(stroke.role), stroke.closed, stroke.width, stroke.points);
        for (const Area& area : page.areas) add("area", static_cast<int>(area.role), area.texture, area.rings);
        for (const Area& area : page.textured) add("textured", static_cast<int>(area.role), area.texture, area.rings);
        for (const BrailleLine& line : page.braille) {
            add("braille", line.first_dot, line.words);
            for (const std::uint8_t cell : line.cells) add(cell);
        }
        for (const PrintLine& line : page.print) add("print", line.baseline, line.size, line.text, line.words);
        for (const PageName& name : page.names) add("name", name.text, name.key, name.thing, name.place, name.words);
        for (const PageWords& words : page.words)
            add("words", name_of(words.kind), words.text, words.key, words.at, words.across, words.down, words.within,
                words.optional);
        for (const Name& name : page.left_out) add("left out", name.at, name.text, name.origin, name.within, name.optional);
        for (const Region& region : page.regions) {
            add("region", region.name.in(page.language), region.path, region.description.in(page.language), region.rings);
            if (!region.rings.empty()) add(region.at);
            for (const auto& [name, count] : region.counts) add(name, count);
        }
        for (const Phrase& remark : page.remarks) add("remark", remark.in(page.language));
        if (page.picture) {
            add("picture", page.picture->width, page.picture->height, page.picture->place);
            for (const std::uint8_t byte : page.picture->bits) add(byte);
        }
    }
    std::string text() const { return out_.str(); }

private:
    template <typename... Things>
    void add(const Things&... things) {
        (put(things), ...);
        out_ << '\n';
    }
    void put(double number) { out_ << std::hexfloat << number << ' '; }
    void put(int number) { out_ << number << ' '; }
    void put(bool flag) { out_ << flag << ' '; }
    void put(std::uint8_t byte) { out_ << int{byte} << ' '; }
    void put(std::string_view text) { out_ << '"' << text << "\" "; }
    void put(const std::string& text) { put(std::string_view(text)); }
    void put(const char* text) { put(std::string_view(text)); }
    void put(Point p) {
        put(p.x);
        put(p.y);
    }
    void put(const Rect& rect) {
        for (const double side : {rect.left, rect.top, rect.width, rect.height}) put(side);
    }
    template <typename Thing>
    void put(const std::vector<Thing>& things) {
        out_ << "[ ";
        for (const Thing& thing : things) put(thing);
        out_ << "] ";
    }
    std::ostringstream out_;
};
std::string spelled_out(const Page& page) { return Spelling(page).text(); }

// Lines of a spelling that are not in the other.
std::vector<std::string> lines_apart(const std::string& a, const std::string& b) {
    std::vector<std::string> out;
    std::istringstream lines(a);
    for (std::string line; std::getline(lines, line);)
        if (("\n" + b).find("\n" + line + "\n") == std::string::npos) out.push_back(line);
    return out;
}

class Chance {
public:
    explicit Chance(unsigned seed) : engine_(seed) {}
    double between(double least, double most) { return std::uniform_real_distribution<double>(least, most)(engine_); }
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
    Point place() { return {between(5, 195), between(5, 285)}; }
    std::vector<Point> line(int points) {
        std::vector<Point> out{place()};
        double way = between(0, 6);
        const double step = between(0.05, 3);
        while (static_cast<int>(out.size()) < points) {
            way += between(-0.5, 0.5);
            out.push_back({std::clamp(out.back().x + step * std::cos(way), 0.0, 200.0),
                           std::clamp(out.back().y + step * std::sin(way), 0.0, 290.0)});
        }
        return out;
    }
    std::string words() {
        static const std::vector<std::string> all{
            "Nest", "Ei & <Huhn>", "\"quoted\"", "größer als 3,5", "مدينة", "Île-de-F", "a b", "🥚 egg", "-->", "'x'"};
        return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
    }

private:
    std::mt19937 engine_;
};

// Anything that a page can hold, without sense.
Page page_by_chance(unsigned seed) {
    Chance chance(seed);
    Page page;
    page.width = chance.below(2) == 0 ? 210 : 200.123456789;
    page.height = 297;
    page.live = {12.7, 12.700000001, 180 / 7.0 * 7, 270};
    page.drawing = {chance.between(10, 20), 30, 170 / 3.0, 100};
    page.braille_dot = 1.6;
    page.medium = chance.below(2) == 0 ? "swell" : "embosser";
    page.braille_table = "de-g1.ctb";
    page.language = "de";
    page.title = chance.words();
    page.caption = chance.below(2) == 0 ? chance.words() : "";
    page.description = chance.words();
    page.is_key = chance.below(5) == 0;
    if (chance.below(3) == 0) page.bed = DotBed{{3.1, 4.7}, chance.below(2) == 0 ? 0 : 2.0, 3 + chance.below(2)};
    if (chance.below(3) == 0) page.scale = PageScale{"5 m", 50 / 3.0, 5000, {1, 2, 3, 4 / 3.0}};
    for (int i = chance.below(20); i > 0; --i) {
        PageStroke stroke{chance.line(2 + chance.below(120)), chance.below(2) == 0,
                          std::array{0.7, 1.0, 1.6, 3.0}[static_cast<std::size_t>(chance.below(4))],
                          static_cast<Role>(chance.below(11))};
        if (chance.below(10) == 0) stroke = {{{50, 50}, {50, 50}}, false, 1, stroke.role};
        if (page.medium == "embosser") stroke.width = 1.6;
        page.strokes.push_back(stroke);
    }
    for (int i = chance.below(5); i > 0; --i)
        page.areas.push_back(
            {{chance.line(3 + chance.below(40)), chance.line(5)}, chance.below(2) == 0 ? Role::line : Role::symbol});
    page.areas.push_back({{{{60, 60}, {61, 60}, {61, 61}, {60, 61}}}, Role::line});
    for (int i = chance.below(3); i > 0; --i) page.textured.push_back({{chance.line(30)}, Role::line, 1 + chance.below(5)});
    for (int i = chance.below(12); i > 0; --i) {
        const int words = static_cast<int>(page.words.size());
        page.words.push_back({static_cast<WordsKind>(chance.below(8)), chance.words(), "", chance.place(), 0.5, 1 / 3.0,
                              chance.between(0, 9), chance.below(2) == 0});
        if (page.words.back().kind != WordsKind::label)
            page.words.back().at = {}, page.words.back().across = page.words.back().down = 0;
        if (page.words.back().kind == WordsKind::key || page.words.back().kind == WordsKind::letters)
            page.words.back().key = "qx";
        const Point at{chance.between(5, 90), chance.between(5, 280)};
        page.braille.push_back({at, {}, words});
        for (int k = 1 + chance.below(9); k > 0; --k)
            page.braille.back().cells.push_back(static_cast<std::uint8_t>(chance.below(256)));
        page.braille.back().cells.push_back(static_cast<std::uint8_t>(1 + chance.below(255)));
        if (chance.below(2) == 0) page.print.push_back({at, 3.53, page.words.back().text, words});
        if (page.words.back().kind == WordsKind::name)
            page.names.push_back({page.words.back().text, "", chance.place(), {at.x, at.y, 10 / 3.0, 7}, words});
    }
    page.braille.push_back({chance.place(), {1, 0, 3}});
    page.print.push_back({chance.place(), 2.82, "alone"});
    page.left_out.push_back({chance.place(), chance.words(), "--label 2", 1 / 3.0, true});
    page.regions.push_back({chance.words(), "A/B", chance.words(), {{"folded", 3}, {"left", 0}}, {}, {}});
    page.regions.push_back({chance.words(), "", "", {{"n", 1}}, {{{10, 10}, {50, 10}, {50, 60}, {10, 60}}}, {30, 20}});
    page.remarks = {chance.words(), "two"};
    if (chance.below(2) == 0) {
        page.picture = Bitmap{13, 5, {20 / 3.0, 30, 40, 50 / 7.0}, {}};
        for (int i = 0; i < 10; ++i)
            page.picture->bits.push_back(static_cast<std::uint8_t>(i % 2 == 1 ? 0xf8 & chance.below(256) : chance.below(256)));
    }
    put_on_steps(page);
    return page;
}

Drawing named_drawing() {
    Drawing drawing = rendered::hard_drawing();
    drawing.names.push_back({{20, 20}, "Nest", "one", 0, false});
    drawing.names.push_back({{150, 100}, "Ei", "two", 0, true});
    drawing.labels.push_back({{10, 110}, 0.5, 1, "3,5"});
    Area area{{{{20, 90}, {60, 90}, {60, 118}, {20, 118}}}, Role::line, 2};
    drawing.areas.push_back(area);
    return drawing;
}

Sheet named_sheet() {
    Sheet sheet = rendered::sheet_of("a4", "Vogel & Nest");
    sheet.braille_table = "de-g1.ctb";
    sheet.language = "de";
    sheet.caption = "im Garten";
    sheet.real_width = 18000;
    return sheet;
}

TEST(OwnPage, AnyPageIsReadBackAsItWas) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        const Page page = page_by_chance(seed);
        const std::string svg = svg_of(page);
        const Page again = read(svg);
        ASSERT_EQ(lines_apart(spelled_out(page), spelled_out(again)), std::vector<std::string>()) << seed;
        ASSERT_EQ(spelled_out(page), spelled_out(again)) << seed;
        ASSERT_EQ(svg_of(again), svg) << seed;
    }
}

TEST(OwnPage, APageThatWasLaidOutIsReadBack) {
    const Page page = lay_out(named_drawing(), named_sheet());
    EXPECT_FALSE(page.names.empty() || page.textured.empty() || !page.scale);
    EXPECT_EQ(spelled_out(page), spelled_out(read(svg_of(page))));
}

TEST(OwnPage, OthersAreNotOurs) {
    EXPECT_FALSE(read_own_page("<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm'/>", "a.svg"));
    std::string svg = svg_of(page_by_chance(1));
    for (const auto& [from, to] : {std::pair("data-tactics-page=\"1\"", "data-tactics-page=\"2\""),
                                   std::pair("data-tactics-live=\"", "data-tactics-live=\"x"),
                                   std::pair("data-tactics-cell=\"", "data-tactics-cell=\"-")}) {
        std::string other = svg;
        other.replace(other.find(from), std::string_view(from).size(), to);
        EXPECT_FALSE(read_own_page(other, "a.svg")) << to;
    }
}

// The element that begins there, up to its end.
std::string without(std::string svg, std::string_view begin, std::string_view end) {
    const auto from = svg.find(begin);
    EXPECT_NE(from, std::string::npos) << begin;
    return svg.erase(from, svg.find(end, from) + end.size() - from);
}

std::string with(std::string svg, std::string_view before, std::string_view what, std::string_view now) {
    const auto at = svg.find(what, svg.find(before));
    EXPECT_NE(at, std::string::npos) << what;
    return svg.replace(at, what.size(), now);
}

TEST(OwnPage, ALineThatWasTakenOutIsGoneAndNothingElse) {
    const Page page = lay_out(named_drawing(), named_sheet());
    Page less = page;
    less.strokes.erase(less.strokes.begin());
    EXPECT_EQ(spelled_out(less), spelled_out(read(without(svg_of(page), "<path data-tactics-n=\"0\" stroke-width", "/>"))));
}

TEST(OwnPage, WordsThatWereMovedTakeTheirBrailleAndLeadAlong) {
    const Page page = lay_out(named_drawing(), named_sheet());
    const PageName& name = page.names.front();
    const std::string begin = "<g class=\"tactics-name\" aria-label=\"" + name.text;
    const Page moved = read(with(svg_of(page), begin, "<g ", "<g transform=\"translate(3.5,-2)\" "));
    for (std::size_t i = 0; i < page.braille.size(); ++i) {
        const bool its = page.braille[i].words == name.words;
        EXPECT_NEAR(moved.braille[i].first_dot.x - page.braille[i].first_dot.x, its ? 3.5 : 0, 1e-9);
        EXPECT_NEAR(moved.braille[i].first_dot.y - page.braille[i].first_dot.y, its ? -2 : 0, 1e-9);
    }
    EXPECT_NEAR(moved.names.front().place.left, name.place.left + 3.5, 1e-9);
    EXPECT_EQ(moved.strokes.size(), page.strokes.size());
    // By its text, which the layer of hidden words has.
    const std::string text = "<text data-tactics-words=\"" + std::to_string(name.words) + "\"";
    const Page by_text = read(with(svg_of(page), text, "<text ", "<text transform=\"translate(3.5,-2)\" "));
    EXPECT_EQ(spelled_out(moved), spelled_out(by_text));
}

TEST(OwnPage, WordsThatWereTypedAnewHaveTheirBrailleInTheTableOfThePage) {
    const Page page = lay_out(named_drawing(), named_sheet());
    for (const auto& [old, text] :
         {std::pair("Nest", "Kraniche"), std::pair("Vogel &amp; Nest", "Größe"), std::pair("3,5", "4")}) {
        const Page typed = read(with(svg_of(page), "<text", ">" + std::string(old) + "<", ">" + std::string(text) + "<"));
        const std::vector<std::uint8_t> cells = to_braille(text, "de-g1.ctb");
        const auto has = [&](const Page& one) {
            return std::count_if(one.braille.begin(), one.braille.end(),
                                 [&](const BrailleLine& line) { return line.cells == cells; });
        };
        EXPECT_EQ(has(page), 0) << text;
        EXPECT_EQ(has(typed), 1) << text;
        EXPECT_EQ(typed.strokes.size(), page.strokes.size());
        EXPECT_EQ(typed.braille.size(), page.braille.size());
    }
    EXPECT_EQ(read(with(svg_of(page), "<text", ">Vogel &amp; Nest<",
                        "><tspan role=\"line\">Zwei</tspan><tspan role=\"line\">Eier</tspan><"))
                  .title,
              "Zwei Eier");
}

TEST(OwnPage, WhatIsDrawnInALayerIsALineOfIt) {
    const Page page = lay_out(named_drawing(), named_sheet());
    const auto drawn = [&](std::string_view layer, const std::string& what) {
        return read(with(svg_of(page), "data-tactics-layer=\"" + std::string(layer) + "\"", ">\n", ">\n" + what + "\n"));
    };
    const std::string line =
        "<path style=\"fill:none;stroke:#000000;stroke-width:0.264583px;stroke-linecap:butt\" d=\"m 30,200 20,10\" "
        "id=\"path99\"/>";
    const Page main = drawn("main-outlines", line), inner = drawn("inner-lines", line);
    const auto lines = [](const Page& one) {
        return std::count_if(one.strokes.begin(), one.strokes.end(),
                             [](const PageStroke& stroke) { return stroke.role == Role::line; });
    };
    ASSERT_EQ(lines(main), lines(page) + 1);
    const auto new_one = [](const Page& one) {
        return *std::find_if(one.strokes.begin(), one.strokes.end(), [](const PageStroke& stroke) {
            return distance(stroke.points[0], {30, 200}) < 0.5;
        });
    };
    EXPECT_EQ(new_one(main).width, 1.0);
    EXPECT_EQ(new_one(main).role, Role::line);
    EXPECT_EQ(new_one(inner).width, 0.7);
    const Page text = drawn("words", "<text x=\"40\" y=\"250\">Eier</text>");
    EXPECT_EQ(text.braille.back().cells, to_braille("Eier", "de-g1.ctb"));
    EXPECT_NEAR(text.braille.back().first_dot.x, 40.8, 1e-9);
}

TEST(OwnPage, InkscapeKeepsThePage) {
    if (std::system("command -v inkscape >/dev/null 2>&1") != 0) GTEST_SKIP() << "inkscape";
    const tests::Folder folder;
    for (const unsigned seed : {3u, 4u}) {
        const Page page = seed == 4 ? lay_out(named_drawing(), named_sheet()) : page_by_chance(seed);
        tests::write_bytes(folder / "page.svg", svg_of(page));
        for (const std::string kind : {"--export-plain-svg", "--export-type=svg"}) {
            const std::string command =
                "cd " + folder.path().string() + " && inkscape " + kind + " -o again.svg page.svg >/dev/null 2>&1";
            ASSERT_EQ(std::system(command.c_str()), 0);
            const Page again = read(tests::bytes_of(folder / "again.svg"));
            EXPECT_EQ(spelled_out(page), spelled_out(again)) << kind;
        }
    }
}

TEST(OwnPage, HostileFilesAreHarmless) {
    const std::string svg = svg_of(lay_out(named_drawing(), named_sheet()));
    std::mt19937 chance(5);
    const std::vector<std::string> bad{"1e308", "-1", "nan", "999999999", "",
                                       "0",     "x",  "1 2", "\xc3\xa4",  "transform=\"scale(1e9)\""};
    for (int round = 0; round < 100; ++round) {
        std::string other = svg;
        for (int k = 0; k < 3; ++k) {
            auto at = other.find("=\"", chance() % other.size());
            if (at == std::string::npos) continue;
            at += 2;
            const auto end = other.find('"', at);
            if (end == std::string::npos) continue;
            other.replace(at, end - at, bad[chance() % bad.size()]);
        }
        try {
            const auto own = read_own_page(other, "page.svg");
            if (!own) continue;
            for (const char* format : {"svg", "pdf", "brf", "text"}) {
                const Format& to = *find_format(format);
                if (own->page.width < 1000 && own->page.height < 1000) to.encode(own->page, Settings(to.options));
            }
            for (const PageStroke& stroke : own->page.strokes)
                for (const Point& p : stroke.points) ASSERT_TRUE(p.x >= 0 && p.x <= own->page.width && p.y >= 0);
        } catch (const Error&) {
        }
    }
}

}  // namespace
}  // namespace tactics::own_page_test
