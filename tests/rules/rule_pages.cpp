// SPDX-License-Identifier: Apache-2.0
// The pages of every rule.
#include "tests/rules/rule_pages.h"

#include <algorithm>

#include "tactics/layout/key.h"
#include "tactics/layout/room.h"
#include "tests/rules/pages.h"

namespace tactics::tests {

namespace {

BrailleLine letters(Point at, std::size_t count = 3) { return {at, std::vector<std::uint8_t>(count, 0x3f)}; }

Page two_lines(double apart) {
    Page page = blank_page();
    add_line(page, {{20, 50}, {120, 50}});
    add_line(page, {{20, 50 + apart}, {120, 50 + apart}});
    return page;
}

// The last dash is shorter, as the line ends where it does.
Page dashed(double dash, double gap) {
    Page page = blank_page();
    for (int i = 0; i < 6; ++i)
        page.strokes.push_back(
            {{{20 + i * (dash + gap), 50}, {20 + i * (dash + gap) + (i == 5 ? dash / 2 : dash - 1), 50}}, false, 1, Role::dash});
    return page;
}

void add_symbol(Page& page, std::vector<Point> ring) { page.strokes.push_back({std::move(ring), true, 1, Role::symbol}); }

void add_arrow(Page& page, Point tip) {
    add_line(page, {{tip.x - 40, tip.y}, tip});
    page.strokes.push_back({{{tip.x - 7, tip.y - 4}, tip, {tip.x - 7, tip.y + 4}}, false, 1, Role::arrow});
}

Page lead(double length) {
    Page page = blank_page();
    page.strokes.push_back({{{50, 50}, {50 + length, 50}}, false, 1, Role::lead});
    return page;
}

Page tick(double one, double other) {
    Page page = blank_page();
    add_line(page, {{20, 50}, {120, 50}});
    page.strokes.push_back({{{70, 50 - one}, {70, 50 + other}}, false, 1, Role::tick});
    return page;
}

// A page with one line of braille, which is what the name's letters, or its line in a key, are.
Page named(const std::string& letters, std::size_t words_from, std::size_t words) {
    Page page = blank_page();
    std::vector<std::uint8_t> cells;
    for (const char letter : letters) cells.push_back(letter_cell(letter));
    if (words > 0) cells.resize(words_from, 0);
    cells.resize(cells.size() + words, 0x3f);
    page.braille.push_back({{20, 150}, cells});
    page.names.push_back({"the town", letters, {20, 150}, extent_of(page.braille[0], page.cell, page.braille_dot)});
    return page;
}

Page keyed(const std::string& letters) { return named(letters, 0, 0); }

Page key_line(std::size_t words_from) {
    Page page = named("tk", words_from, 7);
    page.is_key = true;
    return page;
}

Page inked(double percent) {
    Page page = blank_page();
    page.areas.push_back({{rectangle(10, 0, 200 * percent / 100, 200)}});
    return page;
}

}  // namespace

const std::map<std::string, PageOf>& rule_pages() {
    static const std::map<std::string, PageOf> kPages = {
        {"gap", [](double gap) { return two_lines(gap + 1); }},
        {"merging-dots", [](double apart) { return two_lines(apart); }},
        {"crossings",
         [](double count) {
             Page page = blank_page();
             for (int i = 0; i < static_cast<int>(count); ++i) {
                 const double angle = std::numbers::pi * i / count, x = 60 * std::cos(angle), y = 60 * std::sin(angle);
                 add_line(page, {{100 - x, 100 - y}, {100 + x, 100 + y}});
             }
             return page;
         }},
        {"line-width",
         [](double width) {
             Page page = blank_page();
             add_line(page, {{20, 50}, {120, 50}}, width);
             return page;
         }},
        {"line-styles",
         [](double count) {
             Page page = blank_page();
             for (int i = 0; i < static_cast<int>(count); ++i)  // the last two have one width
                 add_line(page, {{20, 20.0 + 10 * i}, {120, 20.0 + 10 * i}}, 1 + 0.2 * std::min(i, static_cast<int>(count) - 2));
             page.strokes.back().role = Role::dash;
             return page;
         }},
        {"dash-length", [](double dash) { return dashed(dash, dash / 2); }},
        {"long-dashes", [](double dash) { return dashed(dash, dash / 2); }},
        {"dash-gaps", [](double off) { return dashed(8, 8 * (0.5 + off)); }},
        {"symbol-kinds",
         [](double count) {
             Page page = blank_page();
             for (int i = 0; i < static_cast<int>(count); ++i) {
                 const int corners = 3 + i / 2;  // each once as an outline and once filled
                 const auto ring = circle({20.0 + 20 * i, 40}, 5, corners > 4 ? 40 : corners);
                 if (i % 2 == 0)
                     page.areas.push_back({{ring}, Role::symbol});
                 else
                     add_symbol(page, ring);
                 add_symbol(page, circle({20.0 + 20 * i, 80}, 5, 3));  // all of one kind, the second
             }
             return page;
         }},
        {"symbol-size",
         [](double size) {
             Page page = blank_page();
             add_symbol(page, circle({50, 50}, (size - 1) / 2));
             return page;
         }},
        {"symbol-gap",
         [](double gap) {
             Page page = blank_page();
             page.areas.push_back({{rectangle(50, 50, 6, 6)}, Role::symbol});
             page.areas.push_back({{rectangle(56 + gap, 52, 6, 6)}, Role::symbol});
             return page;
         }},
        {"filled-arrows",
         [](double count) {
             Page page = blank_page();
             add_arrow(page, {60, 40});
             add_line(page, {{20, 80}, {52, 80}});
             if (count > 0) page.areas.push_back({{{{60, 80}, {52, 76}, {52, 84}}}, Role::arrow});
             return page;
         }},
        {"arrow-gap",
         [](double gap) {
             Page page = blank_page();
             add_arrow(page, {60, 50});
             add_line(page, {{60 + gap + 1, 20}, {60 + gap + 1, 80}});
             return page;
         }},
        {"lead-width",
         [](double more) {
             Page page = blank_page();
             add_line(page, {{20, 50}, {120, 50}});
             page.strokes.push_back({{{60, 60}, {60, 85}}, false, 1 + more, Role::lead});
             return page;
         }},
        {"lead-length", lead},
        {"short-leads", lead},
        {"lead-arrows",
         [](double count) {
             Page page = lead(30);
             if (count > 0) page.strokes.push_back({{{44, 54}, {50, 50}, {44, 46}}, false, 1, Role::arrow});
             return page;
         }},
        {"tick-length", [](double length) { return tick((length - 1) / 2, (length - 1) / 2); }},
        {"tick-sides", [](double side) { return tick(20, side - 0.5); }},
        {"line-length",
         [](double length) {
             Page page = blank_page();
             add_line(page, {{20, 50}, {20 + length - 1, 50}});
             return page;
         }},
        {"side-length",
         [](double side) {
             Page page = blank_page();
             add_line(page, rectangle(20, 20, side, 40), 1, true);
             return page;
         }},
        {"area-size",
         [](double size) {
             Page page = blank_page();
             page.areas.push_back({{rectangle(20, 20, size * 0.8, size * 0.6)}});
             return page;
         }},
        {"detail",
         [](double size) {
             Page page = blank_page();
             page.areas.push_back({{circle({50, 50}, size / 2)}});
             return page;
         }},
        {"textures",
         [](double count) {
             Page page = blank_page();
             for (int i = 0; i < static_cast<int>(count); ++i)
                 page.textured.push_back({{rectangle(20.0 * i, 20, 15, 15)}, Role::line, i + 1});
             return page;
         }},
        {"texture-size",
         [](double size) {
             Page page = blank_page();
             page.textured.push_back({{rectangle(20, 20, 20, 60)}, Role::line, 2});
             for (int i = 0; i < 10; ++i)
                 page.strokes.push_back({{{30, 30.0 + 3 * i}, {30 + size - 1, 30.0 + 3 * i}}, false, 1, Role::pattern});
             return page;
         }},
        {"texture-clearance",
         [](double apart) {
             Page page = blank_page();
             add_line(page, {{20, 50}, {120, 50}});
             for (int i = 0; i < 10; ++i)
                 page.strokes.push_back({{{30.0 + 3 * i, 51 + apart}, {30.0 + 3 * i, 80}}, false, 1, Role::pattern});
             return page;
         }},
        {"braille-clearance",
         [](double apart) {
             Page page = blank_page();
             page.braille.push_back(letters({50, 50}));
             add_line(page, {{20, 50 + 5 + 0.8 + apart + 0.5}, {120, 50 + 5 + 0.8 + apart + 0.5}});
             return page;
         }},
        {"braille-dots",
         [](double off) {
             Page page = blank_page();
             page.braille.push_back(letters({50, 50}));
             page.cell.dot_pitch = 2.5 + off;
             return page;
         }},
        {"braille-cells",
         [](double off) {
             Page page = blank_page();
             page.braille.push_back(letters({50, 50}));
             page.cell.cell_pitch = 6.0 - off;
             return page;
         }},
        {"braille-lines",
         [](double off) {
             Page page = blank_page();
             page.braille.push_back(letters({50, 50}));
             page.braille.push_back(letters({50, 60 - off}));
             return page;
         }},
        {"key-letters", [](double off) { return keyed(off == 0 ? "tk" : "t"); }},
        {"key-dots", [](double count) { return keyed(count == 0 ? "bw" : "bc"); }},
        {"key-words", [](double off) { return key_line(5 + static_cast<std::size_t>(off)); }},
        {"margin",
         [](double off) {
             Page page = blank_page();
             page.live = {10, 10, 180, 180};
             add_line(page, {{50, 50}, {190 + off, 60}});
             return page;
         }},
        {"paper", [](double square_cm) { return blank_page(100 * square_cm / 300, 300); }},
        {"ink", inked},
        {"ink-limit", inked},
    };
    return kPages;
}

}  // namespace tactics::tests
