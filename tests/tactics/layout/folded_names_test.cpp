// SPDX-License-Identifier: Apache-2.0
// Names in boxes: in several lines where one is too long, and the same letters for the same words.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/name_blocks.h"
#include "tactics/layout/thing_places.h"

namespace tactics::folded_names_test {
namespace {

Sheet sheet() {
    Sheet sheet;
    sheet.paper = find_paper("a4", "test");
    sheet.medium = &find_medium("swell", "test");
    return sheet;
}

// A closed box of that size with a name in its middle, on a drawing with lines all around it.
Drawing boxed(std::vector<std::string> names, double width, double height) {
    Drawing drawing{270, 180, {}, {}, {}};
    double left = 20;
    for (const std::string& name : names) {
        drawing.strokes.push_back({{{left, 50}, {left + width, 50}, {left + width, 50 + height}, {left, 50 + height}}, true});
        drawing.names.push_back({{left + width / 2, 50 + height / 2}, name});
        left += width + 10;
    }
    return drawing;
}

TEST(FoldedNames, WordsTooLongForABoxStandInLinesWithinIt) {
    const Page page = lay_out(boxed({"river station"}, 45, 35), sheet());
    ASSERT_EQ(page.names.size(), 1u);
    EXPECT_TRUE(page.names[0].key.empty());
    ASSERT_EQ(page.braille.size(), 2u);
    EXPECT_NEAR(page.braille[1].first_dot.y - page.braille[0].first_dot.y, page.cell.line_pitch, 1e-9);
    EXPECT_EQ(page.braille[0].words, page.braille[1].words);
    const Rect place = page.names[0].place;
    const Box box = box_of(page.strokes[0].points);
    EXPECT_GT(place.left, box.left);
    EXPECT_LT(place.left + place.width, box.right);
    EXPECT_GT(place.top, box.top);
    EXPECT_LT(place.top + place.height, box.bottom);
    EXPECT_EQ(lay_out(boxed({"river station"}, 90, 35), sheet()).braille.size(), 1u);
}

TEST(FoldedNames, TheSameWordsHaveTheSameLetters) {
    const std::vector<std::string> names(7, "an extraordinarily unpronounceable denomination");
    const Page page = lay_out(boxed(names, 20, 16), sheet());
    ASSERT_EQ(page.names.size(), 7u);
    std::set<std::string> keys;
    for (const PageName& name : page.names) keys.insert(name.key);
    keys.erase("");  // beside the last box there is room for the words
    EXPECT_EQ(keys.size(), 1u);
    EXPECT_GE(std::count_if(page.names.begin(), page.names.end(), [](const PageName& name) { return !name.key.empty(); }), 2);
    EXPECT_EQ(std::count_if(page.words.begin(), page.words.end(), [](const auto& one) { return one.kind == WordsKind::key; }), 1);
}

// A box that is too small for its words, between boxes that have room: nothing that stands in a box is of another.
TEST(FoldedNames, WordsOfABoxStandInNoOther) {
    Drawing drawing{270, 180, {}, {}, {}};
    for (const double left : {20.0, 62.0, 78.0}) {
        const double right = left + (left == 62 ? 14 : 40);
        drawing.strokes.push_back({{{left, 50}, {right, 50}, {right, 75}, {left, 75}}, true});
    }
    for (const double y : {40.0, 85.0}) drawing.strokes.push_back({{{0, y}, {270, y}}});
    drawing.names.push_back({{69, 62.5}, "river"});
    const Page page = lay_out(drawing, sheet());
    ASSERT_EQ(page.names.size(), 1u);
    const Point middle = page.names[0].place.middle();
    for (const std::size_t box : {0u, 2u}) EXPECT_FALSE(box_of(page.strokes[box].points).holds(middle)) << box;
    const ClosedShapes shapes(page);
    EXPECT_TRUE(shapes.any_around_only(box_of(page.strokes[0].points).middle(), box_of(page.strokes[1].points).middle()));
    EXPECT_FALSE(shapes.any_around_only({1, 1}, box_of(page.strokes[1].points).middle()));
}

// Whatever the words: they come in their order, whole, in no more lines than asked for, and ever narrower.
TEST(FoldedNames, LinesHaveAllWordsInTheirOrder) {
    Page page;
    const std::vector<std::vector<std::uint8_t>> texts{
        {1, 1, 0, 2, 0, 3, 3, 3}, {1}, {1, 0, 1, 0, 1, 0, 1, 0, 1}, {1, 2, 3, 4, 5, 6, 0, 7}, {0, 1, 0, 0, 2}};
    for (const auto& cells : texts) {
        LabelBlock line;
        line.height = 6;
        line.braille.push_back({{1, 1}, cells});
        double before = dots_width(cells.size(), page);
        for (const LabelBlock& block : folded(line, 3, page)) {
            EXPECT_GE(block.braille.size(), 2u);
            EXPECT_LE(block.braille.size(), 3u);
            EXPECT_LT(block.width, before);
            before = block.width;
            EXPECT_NEAR(block.height, 6 + static_cast<double>(block.braille.size() - 1) * page.cell.line_pitch, 1e-9);
            std::vector<std::uint8_t> all;
            for (const BrailleLine& one : block.braille) {
                EXPECT_LE(dots_width(one.cells.size(), page), block.width + 1e-9);
                std::copy_if(one.cells.begin(), one.cells.end(), std::back_inserter(all), [](auto cell) { return cell != 0; });
            }
            std::vector<std::uint8_t> words = cells;
            std::erase(words, 0);
            EXPECT_EQ(all, words);
        }
    }
    LabelBlock one;
    one.braille.push_back({{1, 1}, {1, 2, 3}});
    EXPECT_TRUE(folded(one, 3, page).empty());
}

}  // namespace
}  // namespace tactics::folded_names_test
