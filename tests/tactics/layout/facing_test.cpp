// SPDX-License-Identifier: Apache-2.0
// Both sides of a sheet: nothing lies on the back of a drawing, and a bound book has the key beside it.
#include "tactics/layout/facing.h"

#include <gtest/gtest.h>

#include "print/format.h"
#include "tactics/layout/lay_out.h"
#include "tests/print/brf_reader.h"

namespace tactics::facing_test {
namespace {

// As many pages as asked for, told apart by their titles.
Pages sides(std::size_t drawn, std::size_t key) {
    Pages pages;
    std::vector<Page> keys;
    for (std::size_t i = 0; i < drawn + key; ++i) {
        Page page;
        page.width = page.height = 100;
        page.strokes.push_back({{{10, 10}, {20, 20}}, false, 1});
        page.is_key = i >= drawn;
        page.title = i < drawn ? "d" + std::to_string(i + 1) : "k" + std::to_string(i - drawn + 1);
        (page.is_key ? keys : pages.all).push_back(page);
    }
    return on_both_sides(std::move(pages), std::move(keys));
}

std::string order(std::size_t drawn, std::size_t key) {
    std::string text;
    for (const Page& page : sides(drawn, key).all) text += (text.empty() ? "" : " ") + (is_blank(page) ? "-" : page.title);
    return text;
}

TEST(Facing, PutsTheKeyBesideTheDrawing) {
    EXPECT_EQ(order(1, 0), "d1");
    EXPECT_EQ(order(1, 1), "- k1 d1") << "the back of the first sheet faces the front of the second";
    EXPECT_EQ(order(1, 2), "- d1 k1 - k2") << "the drawing to the left, the key on the fronts behind it";
    EXPECT_EQ(order(2, 0), "d1 - d2");
    EXPECT_EQ(order(2, 1), "- k1 d1 - d2");
    EXPECT_EQ(order(3, 2), "k1 k2 d1 - d2 - d3");
    EXPECT_EQ(order(2, 3), "- k1 k2 k3 d1 - d2");
}

TEST(Facing, NothingLiesOnTheBackOfADrawing) {
    for (std::size_t drawn = 1; drawn < 8; ++drawn)
        for (std::size_t key = 0; key < 6; ++key) {
            const Pages pages = sides(drawn, key);
            std::size_t inked = 0;
            for (std::size_t i = 0; i < pages.all.size(); ++i) {
                inked += is_blank(pages.all[i]) ? 0 : 1;
                if (is_blank(pages.all[i]) || pages.all[i].is_key) continue;
                const std::size_t back = i % 2 == 0 ? i + 1 : i - 1;
                EXPECT_TRUE(back >= pages.all.size() || is_blank(pages.all[back])) << drawn << ' ' << key << ' ' << i;
            }
            EXPECT_EQ(inked, drawn + key) << "none is lost";
            EXPECT_EQ(pages.whole().title, "d1");
            EXPECT_FALSE(is_blank(pages.all.back()));
        }
}

// As an embosser gets them: a page of the file is a side.
TEST(Facing, AnEmbosserGetsTheSidesInTheirOrder) {
    Sheet sheet;
    sheet.paper = find_paper("11x11.5", "test");
    sheet.medium = &find_medium("embosser", "test");
    sheet.title = "Town";
    sheet.duplex = true;
    Drawing drawing{200, 100, {Stroke{{{0, 50}, {200, 50}}}}, {}, {}};
    drawing.names = {
        {{20, 50}, "Donaudampfschifffahrtselektrizitätenhauptbetriebswerkbauunterbeamtengesellschaftsverwaltungsgebäudeeingang"}};
    const Pages pages = pages_of(drawing, sheet);
    ASSERT_EQ(pages.all.size(), 3u);
    const Format& brf = *find_format("brf");
    const auto read = test::read_brf(brf.encode_pages(pages.all, Settings(brf.options)));
    ASSERT_EQ(read.size(), 3u);
    EXPECT_TRUE(read[0].dots.empty());
    EXPECT_TRUE(pages.all[1].is_key);
    EXPECT_FALSE(read[1].dots.empty());
    EXPECT_FALSE(read[2].dots.empty());
    // A package has no sides.
    const Format& ebrl = *find_format("ebrl");
    EXPECT_EQ(ebrl.encode_pages(pages.all, Settings(ebrl.options)).find("drawing-3.svg"), std::string::npos);
}

}  // namespace
}  // namespace tactics::facing_test
