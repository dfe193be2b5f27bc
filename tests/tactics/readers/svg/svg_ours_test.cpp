// SPDX-License-Identifier: Apache-2.0
// What our own SVG says in classes is read back.
#include "tactics/readers/svg/svg_ours.h"

#include <gtest/gtest.h>

#include "print/format.h"
#include "tactics/layout/room.h"
#include "tactics/readers/svg/svg.h"
#include "tests/rules/pages.h"

namespace tactics::svg_ours_test {
namespace {

using namespace tests;

std::string svg_of(const Page& page) {
    const Format& svg = *find_format("svg");
    return svg.encode(page, Settings(svg.options));
}

Page read(const std::string& svg) { return read_svg(svg, "page.svg", 0, std::nullopt).page; }

void add_name(Page& page, const std::string& text, const std::string& key, Point at, std::vector<std::uint8_t> cells) {
    page.braille.push_back({at, std::move(cells)});
    page.names.push_back({text, key, at, extent_of(page.braille.back(), page.cell, page.braille_dot)});
}

// A title, a name of two lines, and letters without a dot in their first column or row, which nobody could know from dots.
Page braille_page() {
    Page page = blank_page();
    page.cell = {2.34, 6.2, 10, 1.5};
    page.braille.push_back({{20, 20}, {0x20, 0x13, 0, 0xff}});
    add_name(page, "Old & \"new\"", "", {60.12, 40.34}, {0x07, 0x15});
    page.braille.push_back({{60.12, 50.34}, {0x24}});
    page.names.back().place.height += 10;
    add_name(page, "Lake", "la", {100, 77.77}, {0x30, 0x24});
    return page;
}

TEST(SvgOurs, BrailleAndNamesAreReadBack) {
    const Page page = braille_page(), found = read(svg_of(page));
    EXPECT_TRUE(found.strokes.empty() && found.areas.empty()) << "all dots are braille";
    ASSERT_EQ(found.braille.size(), page.braille.size());
    for (std::size_t i = 0; i < page.braille.size(); ++i) {
        EXPECT_EQ(found.braille[i].cells, page.braille[i].cells) << i;
        EXPECT_NEAR(distance(found.braille[i].first_dot, page.braille[i].first_dot), 0, 0.005) << i;
    }
    EXPECT_EQ(found.cell.dot_pitch, 2.34);
    EXPECT_EQ(found.cell.cell_pitch, 6.2);
    ASSERT_EQ(found.names.size(), 2u);
    EXPECT_EQ(found.names[0].text, "Old & \"new\"");
    EXPECT_EQ(found.names[0].key, "");
    EXPECT_NEAR(found.names[0].place.height, page.names[0].place.height, 0.02);
    EXPECT_EQ(found.names[1].key, "la");
    EXPECT_FALSE(found.is_key);
}

Page page_of_regions() {
    Page page = blank_page();
    page.strokes.push_back({{{20, 20}, {80, 20}, {80, 60}, {20, 60}}, true, 1});
    page.regions.push_back({"Top & \"cover\"",
                            "Table/Top",
                            "seen from above",
                            {{"kept", 1}},
                            {{{20, 20}, {80, 20}, {80, 60}, {20, 60}}, {{40, 30}, {40, 50}, {60, 50}, {60, 30}}},
                            {30, 40}});
    page.regions.push_back({"T\xc3\xbcr", "", "", {}, {{{50, 20}, {110, 20}, {110, 90}, {50, 90}}}, {100, 80}});
    page.regions.push_back({"Pin", "Pin", "too small", {}, {}, {}});
    return page;
}

TEST(SvgOurs, RegionsAreReadBackAndNeverDrawn) {
    const Page page = page_of_regions();
    const std::string svg = svg_of(page);
    for (const SvgPurpose purpose : {SvgPurpose::page, SvgPurpose::figure, SvgPurpose::lines}) {
        const Page found = read_svg(svg, "page.svg", 0, std::nullopt, purpose).page;
        EXPECT_EQ(found.strokes.size(), 1u);
        EXPECT_TRUE(found.areas.empty());
        ASSERT_EQ(found.regions.size(), 2u) << "what is not drawn has no place";
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(found.regions[i].name.english(), page.regions[i].name.english());
            EXPECT_EQ(found.regions[i].path, page.regions[i].path);
            EXPECT_EQ(found.regions[i].description.english(), page.regions[i].description.english());
            EXPECT_TRUE(holds(found.regions[i], page.regions[i].at));
            EXPECT_TRUE(holds(page.regions[i], found.regions[i].at));
        }
        EXPECT_FALSE(holds(found.regions[0], {50, 40})) << "its hole is filled";
    }
    // A program that paints them does not make them lines.
    std::string painted = svg;
    painted.replace(painted.find("<g id=\"regions\" fill=\"none\""), 27, "<g id=\"regions\" fill=\"#000\" stroke=\"#000\"");
    EXPECT_EQ(read(painted).strokes.size(), 1u);
    EXPECT_TRUE(read(painted).areas.empty());
}

TEST(SvgOurs, WhoHasNoRegionsWritesNone) {
    EXPECT_EQ(svg_of(blank_page()).find("region"), std::string::npos);
    // Nor is what lies beside the page, or has no name, one.
    std::string svg = svg_of(page_of_regions());
    svg.replace(svg.find("<title id=\"region-1-title\">"), 27, "<title id=\"region-1-title\"></title><title>");
    svg.insert(svg.find("</svg>"), "<path class=\"tactics-region\" d=\"M-9 0l5 0 0 5z\"><title>Off</title></path>");
    for (const Region& region : read(svg).regions) EXPECT_NE(region.name.english(), "Off");
}

TEST(SvgOurs, AKeyIsOne) {
    Page page = braille_page();
    page.is_key = true;
    EXPECT_TRUE(read(svg_of(page)).is_key);
}

// Somebody made the drawing larger, or moved a dot, in a drawing program.
TEST(SvgOurs, WhatWasChangedSinceIsSeen) {
    std::string svg = svg_of(braille_page());
    const std::string group = "<g id=\"layer-braille\"";
    std::string larger = svg;
    larger.replace(larger.find(group), group.size(), group + " transform=\"scale(1.1)\"");
    const Page scaled = read(larger);
    EXPECT_NEAR(scaled.cell.dot_pitch, 2.34 * 1.1, 1e-9);
    EXPECT_EQ(scaled.braille[3].cells, (std::vector<std::uint8_t>{0x30, 0x24}));
    const auto moved = svg.rfind("cx=\"");
    svg.insert(moved + 4, "1");
    const Page found = read(svg);
    EXPECT_TRUE(std::none_of(found.braille.begin(), found.braille.end(), [](const BrailleLine& line) {
        return line.cells == std::vector<std::uint8_t>{0x30, 0x24};
    }));
    EXPECT_EQ(found.names.size(), 1u) << "a name is where its braille is";
}

TEST(SvgOurs, WhatIsNoneOfOursIsNothing) {
    for (const std::string classes :
         {"tactics-cells-", "tactics-cells-7", "tactics-cells-zz", "tactics-cells-01", "cells-0101"}) {
        const Page page = read(
            "<svg xmlns='http://www.w3.org/2000/svg' width='99mm' height='99mm' viewBox='0 0 99 99'><g "
            "class='tactics-cell-2.5-6-10-1.6'>"
            "<g class='" +
            classes + "'><circle cx='9' cy='9' r='.8'/><circle cx='40' cy='50' r='.8'/></g></g></svg>");
        EXPECT_TRUE(page.braille.empty()) << classes;
        EXPECT_EQ(page.strokes.size(), 2u) << classes;
    }
    for (const std::string cell :
         {"tactics-cell-", "tactics-cell-2.5", "tactics-cell-2.5-0-10-1", "tactics-cell-1e999-6-10-1", "cell-2.5-6-10-1.6"}) {
        Element group;
        group.attributes = {{"class", cell}};
        EXPECT_FALSE(cell_told(group, 1)) << cell;
    }
}

}  // namespace
}  // namespace tactics::svg_ours_test
