// SPDX-License-Identifier: Apache-2.0
// A page in words: everything main is told once, at its place, and the words follow what is drawn.
#include "tactics/description/description.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "tactics/geometry/shape.h"
#include "tactics/layout/lay_out.h"
#include "tests/print/hard_pages.h"

namespace tactics::description_test {
namespace {

using rendered::ring;

Page empty_page() {
    Page page;
    page.width = 210;
    page.height = 297;
    page.live = {10, 10, 190, 277};
    return page;
}

PageStroke circle(Point centre, double radius) { return {ring(centre, radius, 60), true, 1}; }

std::string all_of(const Description& description) {
    std::string text;
    for (const auto& line : lines_of(description)) text += line + "\n";
    return text;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::vector<std::string> kPlaces{"upper left",   "upper middle", "upper right",  "middle left", "middle",
                                       "middle right", "lower left",   "lower middle", "lower right"};
Point ninth(const Page& page, std::size_t i) {
    return {page.width * (static_cast<double>(i % 3) * 2 + 1) / 6, page.height * (static_cast<double>(i / 3) * 2 + 1) / 6};
}

TEST(Description, AnEmptyPageSaysSo) {
    EXPECT_EQ(all_of(describe(empty_page())), "Page: A4 portrait, 21 cm wide and 29.7 cm high.\nThe page is empty.\n");
    const Page titled = lay_out(Drawing{180, 120, {}, {}, {}, {}}, rendered::sheet_of("a4", "Nothing!"));
    const std::string text = all_of(describe(titled));
    EXPECT_TRUE(has(text, "Title: Nothing!\n")) << text;
    EXPECT_TRUE(has(text, "\nBesides the writing the page is empty.\nThe title stands at the top in print and in braille.\n"))
        << text;
}

TEST(Description, ATextureIsToldWithItsArea) {
    Page page = empty_page();
    page.textured.push_back({{ring({60, 60}, 30, 60)}, Role::line, 1});
    page.textured.push_back({{{{120, 150}, {190, 150}, {190, 250}, {120, 250}}, ring({155, 200}, 10, 40)}, Role::line, 2});
    for (int i = 0; i < 50; ++i) page.strokes.push_back({{{40.0 + i, 60}, {40.0 + i, 60}}, false, 2, Role::pattern});
    page.strokes.push_back(circle({60, 60}, 30));
    const std::string outlined = all_of(describe(page));
    EXPECT_TRUE(has(outlined, "It fills number 1.") || has(outlined, "It is the outline of number 1.")) << outlined;
    EXPECT_FALSE(has(outlined, "crosses")) << outlined;
    page.strokes.pop_back();
    const std::string text = all_of(describe(page));
    EXPECT_TRUE(has(text, "On it: 1 area of coarse dots and 1 area of level lines.\n")) << text;
    EXPECT_TRUE(has(text, "A circle filled with coarse dots, 6 cm across, in the upper left.")) << text;
    EXPECT_TRUE(has(text, " filled with level lines with 1 hole, 7 cm wide and 10 cm high")) << text;
    EXPECT_FALSE(has(text, "dots, and") || has(text, "line,")) << "marks are no things: " << text;
}

TEST(Description, AThingAloneIsToldByItsPlaceOnThePage) {
    for (std::size_t i = 0; i < 9; ++i) {
        Page page = empty_page();
        page.strokes.push_back(circle(ninth(page, i), 20));
        const Description description = describe(page);
        ASSERT_EQ(description.things.size(), 1u);
        EXPECT_EQ(description.things[0].what.english(), "A circle, 4 cm across");
        EXPECT_EQ(description.things[0].place.english(), "in the " + kPlaces[i]);
    }
}

// Nine circles, the first seven in size: each is told once, in reading order, with its own place.
TEST(Description, EveryMainThingIsToldOnceFromTopToBottom) {
    Page page = empty_page();
    const std::vector<std::size_t> order{4, 8, 0, 2, 6, 1, 7, 3, 5};
    for (std::size_t i = 0; i < 9; ++i) page.strokes.push_back(circle(ninth(page, order[i]), 25 - static_cast<double>(i)));
    const Description description = describe(page);
    ASSERT_EQ(description.things.size(), 7u);
    std::vector<std::size_t> left{0, 1, 2, 4, 6, 7, 8};
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(description.things[i].place.english(), "in the " + kPlaces[left[i]]);
        EXPECT_EQ(order[description.things[i].index], left[i]);
    }
    EXPECT_TRUE(has(description.rest.english(), "There are 2 more lines, ")) << description.rest.english();
    EXPECT_TRUE(has(description.rest.english(), "most of them in the middle left and the middle right."))
        << description.rest.english();
}

TEST(Description, TheLongestAreTheMainOnesAndTheSumIsRight) {
    Page page = empty_page();
    std::vector<double> lengths;
    for (int i = 0; i < 100'000; ++i) {
        const double x = 20 + i % 150, y = 20 + (i / 150) % 250, length = 0.5 + static_cast<double>(i * 7919LL % 99'991) * 1e-4;
        page.strokes.push_back({{{x, y}, {x, y + length}}, false, 1});
        lengths.push_back(length);
    }
    const Description description = describe(page);
    std::set<std::size_t> naive, told;
    std::vector<std::size_t> by_length(lengths.size());
    std::iota(by_length.begin(), by_length.end(), std::size_t{0});
    std::stable_sort(by_length.begin(), by_length.end(), [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
    naive.insert(by_length.begin(), by_length.begin() + 7);
    for (const Thing& thing : description.things) told.insert(thing.index);
    EXPECT_EQ(told, naive);
    const double sum = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    EXPECT_TRUE(has(all_of(description), "On it: 100000 lines, " + spoken_length(sum).english() + " together."))
        << all_of(description);
    EXPECT_EQ(all_of(description), all_of(describe(page)));
}

Page composed() {
    Page page = empty_page();
    page.strokes.push_back(circle({60, 80}, 25));
    page.strokes.push_back(circle({62, 82}, 8));
    page.strokes.push_back({{{100, 60}, {100, 140}}, false, 1});
    page.strokes.push_back({{{70, 120}, {130, 120}}, false, 1});
    page.strokes.push_back({{{100, 140}, {125, 100}}, false, 3});
    page.areas.push_back({{ring({70, 160}, 12, 50), ring({70, 160}, 5, 50)}});
    return page;
}

TEST(Description, RelationsAreTold) {
    const Description description = describe(composed());
    std::vector<std::string> what(6);
    for (std::size_t i = 0; i < description.things.size(); ++i) {
        const Thing& thing = description.things[i];
        what[thing.area ? 5 : thing.index] =
            std::to_string(i + 1) + ". " + thing.what.english() + "; " + thing.relations.english();
    }
    const auto number = [&](std::size_t i) { return what[i].substr(0, 1); };
    EXPECT_TRUE(has(what[1], "A circle, 1.5 cm across; It lies inside number " + number(0))) << what[1];
    EXPECT_TRUE(has(what[0], "A circle, 5 cm across; ") && !has(what[0], "inside")) << what[0];
    EXPECT_TRUE(has(what[3] + what[2], "crosses number ")) << what[3] << what[2];
    EXPECT_TRUE(has(what[4], "A thick straight line rising to the right")) << what[4];
    EXPECT_TRUE(has(what[4] + what[2], "meets number ")) << what[4] << what[2];
    EXPECT_TRUE(has(what[5], "A filled circle with 1 hole, 2.5 cm across")) << what[5];
}

TEST(Description, WhatMovesTogetherKeepsItsPlacesInTheDrawing) {
    const Page page = composed();
    Page lower = page;
    for (auto& stroke : lower.strokes)
        for (Point& p : stroke.points) p = {p.x + 60, p.y + 110};
    for (auto& ring_of : lower.areas[0].rings)
        for (Point& p : ring_of) p = {p.x + 60, p.y + 110};
    std::vector<std::string> before = lines_of(describe(page)), after = lines_of(describe(lower));
    ASSERT_EQ(before.size(), after.size());
    int changed = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i] != after[i]) {
            ++changed;
            EXPECT_EQ(before[i], "The drawing is 9.5 cm wide and 12 cm high, in the middle of the page.");
            EXPECT_EQ(after[i], "The drawing is 9.5 cm wide and 12 cm high, in the lower right of the page.");
        }
    EXPECT_EQ(changed, 1);
}

// Half a turn of the page: what was upper left is lower right.
TEST(Description, TurningThePageTurnsThePlaces) {
    Page page = composed(), turned = page;
    const auto turn = [&](Point& p) { p = {page.width - p.x, page.height - p.y}; };
    for (auto& stroke : turned.strokes) std::for_each(stroke.points.begin(), stroke.points.end(), turn);
    for (auto& ring_of : turned.areas[0].rings) std::for_each(ring_of.begin(), ring_of.end(), turn);
    const Description before = describe(page), after = describe(turned);
    int in_ninths = 0;
    for (const Thing& thing : before.things)
        for (const Thing& other : after.things) {
            if (thing.area != other.area || thing.index != other.index) continue;
            const std::string words = thing.place.english();
            const std::string place = words.substr(std::min(words.size(), std::string("in the ").size()));
            const auto at = std::find(kPlaces.begin(), kPlaces.end(), place);
            if (at == kPlaces.end()) continue;
            EXPECT_EQ(other.place.english(), "in the " + kPlaces[8 - static_cast<std::size_t>(at - kPlaces.begin())]);
            ++in_ninths;
        }
    EXPECT_GE(in_ninths, 3);
}

TEST(Description, APictureOfDotsIsToldByWhereItIsBlack) {
    Page page = empty_page();
    Bitmap picture{90, 90, {60, 100, 90, 90}, {}};
    picture.bits.assign(picture.row_bytes() * 90, 0);
    for (std::size_t y = 60; y < 90; ++y)
        for (std::size_t x = 0; x < 3; ++x) picture.bits[y * picture.row_bytes() + x] = 0xFF;
    page.picture = picture;
    const std::string text = all_of(describe(page));
    EXPECT_TRUE(has(
        text,
        "A picture of dots, 9 cm wide and 9 cm high, in the middle: 9 percent of it is raised, most of it in the lower left."))
        << text;
    page.picture->bits.assign(picture.bits.size(), 0);
    EXPECT_TRUE(has(all_of(describe(page)), "The page is empty.")) << all_of(describe(page));
}

TEST(Description, WordsOnThePageAreReadOut) {
    Drawing drawing = rendered::hard_drawing();
    drawing.labels.push_back({{20, 110}, 0, 0.5, "low"});
    drawing.labels.push_back({{150, 5}, 0, 0.5, "high"});
    Sheet sheet = rendered::sheet_of("a4", "Two words");
    sheet.orientation = Orientation::portrait;
    const std::string text = all_of(describe(lay_out(drawing, sheet)));
    EXPECT_TRUE(has(text, "Title: Two words.\n")) << text;
    EXPECT_TRUE(has(text, "Words on the page: \"low\" in the middle left and \"high\" in the upper right.\n")) << text;
    EXPECT_TRUE(has(text, "\nBraille: 3 lines with ")) << text;
}

TEST(Description, APersonsWordsWin) {
    Sheet sheet = rendered::sheet_of("a4", "Balloon");
    sheet.description = " A balloon\nover hills ";
    sheet.language = "en-GB";
    const Page page = lay_out(rendered::hard_drawing(), sheet);
    EXPECT_EQ(alternative_text(page, describe(page)), "A balloon over hills");
    EXPECT_EQ(alternative_language(page), "en-GB");
    sheet.description.clear();
    const Page own = lay_out(rendered::hard_drawing(), sheet);
    EXPECT_TRUE(alternative_text(own, describe(own)).starts_with("Page: A4 "));
    EXPECT_EQ(alternative_language(own), "en");
}

// Whole sentences with their plurals and marks; not a word of English is left.
TEST(Description, IsInTheLanguageOfThePage) {
    Page page = composed();
    page.title = "Haus";
    page.print.push_back({{20, 270}, 5, "Tor"});
    page.textured.push_back({{ring({60, 250}, 15, 60)}, Role::line, 1});
    page.language = "de-AT";
    const std::string german = all_of(describe(page));
    EXPECT_TRUE(has(german, "Titel: Haus.\nBlatt: A4 Hochformat, 21 cm breit und 29,7 cm hoch.\n")) << german;
    EXPECT_TRUE(has(german, "Darauf: 5 Linien (zusammen ")) << german;
    EXPECT_TRUE(has(german, "1 Fl\u00e4che mit der Textur \u201egrobe Punkte\u201c.\n")) << german;
    EXPECT_TRUE(has(german, "\u201eTor\u201c unten links")) << german;
    EXPECT_TRUE(has(german, "Kreis, ausgef\u00fcllt, mit 1 Loch, 2,5 cm Durchmesser, ")) << german;
    EXPECT_TRUE(has(german, "Gerade, nach rechts ansteigende Linie, dick, 4,5 cm lang, ")) << german;
    EXPECT_TRUE(has(german, "Liegt innerhalb von Nummer ")) << german;
    page.language = "fr";
    const std::string french = all_of(describe(page));
    EXPECT_TRUE(has(french, "Page\u00a0: A4 portrait, 21 cm de large et 29,7 cm de haut.\n")) << french;
    EXPECT_TRUE(has(french, "\u00ab\u00a0Tor\u00a0\u00bb en bas \u00e0 gauche")) << french;
    EXPECT_TRUE(has(french, "Cercle, surface pleine, avec 1 trou, 2,5 cm de diam\u00e8tre, ")) << french;
    page.language = "pl";
    EXPECT_TRUE(has(all_of(describe(page)), "Page: A4 portrait, 21 cm wide and 29.7 cm high.\n"));
    EXPECT_EQ(alternative_language(page), "en") << "there are no Polish words";
    for (const char* word : {" the ", " and ", " wide", " high", "number", "Page:", "filled", "across"}) {
        EXPECT_FALSE(has(german, word)) << word << "\n" << german;
        EXPECT_FALSE(has(french, word)) << word << "\n" << french;
    }
}

}  // namespace
}  // namespace tactics::description_test
