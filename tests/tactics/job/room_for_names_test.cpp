// SPDX-License-Identifier: Apache-2.0
// Where a drawing stands and how large it is, so that its names have room.
#include "tactics/job/room_for_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/place.h"

namespace tactics::room_for_names_test {
namespace {

Sheet sheet() {
    Sheet sheet;
    sheet.paper = find_paper("a4", "test");
    sheet.medium = &find_medium("swell", "test");
    sheet.braille_table = "en-ueb-g1.ctb";
    return sheet;
}

// Lines all over the drawing that leave no room for braille, and names at its right side, or so many mm beside it.
SizedDrawing lined(double aspect, int count, double aside = 0) {
    const auto names = [=](double width) {
        std::vector<Name> out;
        for (int i = 0; i < count; ++i)
            out.push_back(
                {{width + aside, width / aspect * (i + 0.5) / count}, std::string(3, static_cast<char>('a' + i)), "test"});
        return out;
    };
    return {names, [=](double width) {
                Drawing drawing;
                drawing.width = width;
                drawing.height = width / aspect;
                for (double y = 0; y <= drawing.height; y += 6) drawing.strokes.push_back({{{0, y}, {width, y}}});
                drawing.names = names(width);
                return drawing;
            }};
}

double widest(double aspect) { return place_on(sheet(), aspect).drawing.width; }

// It is on the paper within its margins, below the title.
void expect_on_sheet(const Place& place) {
    constexpr double kSlack = 1e-6;
    EXPECT_GE(place.drawing.left, place.live.left - kSlack);
    EXPECT_GE(place.drawing.top, place.live.top - kSlack);
    EXPECT_LE(place.drawing.left + place.drawing.width, place.live.left + place.live.width + kSlack);
    EXPECT_LE(place.drawing.top + place.drawing.height, place.live.top + place.live.height + kSlack);
}

TEST(RoomForNames, WithoutNamesTheDrawingIsAsLargeAsItCanBe) {
    int drawn = 0;
    SizedDrawing drawing = lined(1, 0);
    const auto draw = drawing.draw;
    drawing.draw = [&](double width) {
        ++drawn;
        return draw(width);
    };
    const auto found = place_with_room(sheet(), 1, drawing);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->arrangement.place.drawing.width, widest(1));
    EXPECT_EQ(found->left_out, 0u);
    EXPECT_EQ(drawn, 1);  // no smaller one can be better
}

TEST(RoomForNames, ASmallerDrawingMakesRoomForNamesAtItsSide) {
    const SizedDrawing drawing = lined(1.5, 8);
    const auto found = place_with_room(sheet(), 1.5, drawing);
    ASSERT_TRUE(found);
    const Rect& place = found->arrangement.place.drawing;
    EXPECT_LT(place.width, widest(1.5));
    const Page page = lay_out(drawing.draw(place.width), sheet(), found->arrangement);
    EXPECT_EQ(page.names.size(), 8u);
    for (const PageName& name : page.names) EXPECT_TRUE(name.key.empty()) << name.text;
    // Larger ones have no room at all.
    EXPECT_THROW(lay_out(drawing.draw(widest(1.5)), sheet()), Error);
}

TEST(RoomForNames, TheDrawingMovesAsideForNamesBesideIt) {
    const SizedDrawing drawing = lined(1.5, 5, 4);
    const auto found = place_with_room(sheet(), 1.5, drawing);
    ASSERT_TRUE(found);
    const Place& place = found->arrangement.place;
    expect_on_sheet(place);
    const double left = place.drawing.left - place.live.left,
                 right = place.live.left + place.live.width - place.drawing.left - place.drawing.width;
    EXPECT_GT(right, left + 15);  // three cells and the gap
    // Little is given up, and all names stand where they belong, without leads.
    EXPECT_GT(place.drawing.width, 0.85 * widest(1.5));
    const Page page = lay_out(drawing.draw(place.drawing.width), sheet(), found->arrangement);
    ASSERT_EQ(page.names.size(), 5u);
    for (const PageName& name : page.names) EXPECT_GT(name.place.left, place.drawing.left + place.drawing.width);
    EXPECT_TRUE(std::none_of(page.strokes.begin(), page.strokes.end(), [](const PageStroke& s) { return s.role == Role::lead; }));
}

TEST(RoomForNames, TheSheetIsTurnedIfNamesThenLeaveMoreToTheDrawing) {
    // As high as wide: the other way up there is more room at its sides.
    const auto with = [&](const std::string& words) {
        SizedDrawing drawing = lined(1, 0);
        drawing.names = [words](double width) {
            return std::vector<Name>{{{-5, width / 2}, words, "test"}, {{width + 5, width / 2}, words, "test"}};
        };
        const auto draw = drawing.draw;
        drawing.draw = [draw, names = drawing.names](double width) {
            Drawing made = draw(width);
            made.names = names(width);
            return made;
        };
        const auto found = place_with_room(sheet(), 1, drawing);
        EXPECT_TRUE(found);
        expect_on_sheet(found->arrangement.place);
        return found->arrangement.place;
    };
    const Place beside = with("sea");
    EXPECT_GT(beside.page_width, beside.page_height);
    EXPECT_EQ(beside.drawing.width, widest(1));
}

TEST(RoomForNames, NoPlaceIsFoundWhereNoWidthHasRoom) {
    int drawn = 0;
    const SizedDrawing drawing{[](double) { return std::vector<Name>(); },
                               [&](double) -> Drawing {
                                   ++drawn;
                                   throw Error(Fault::usage, "test", "no room");
                               }};
    EXPECT_FALSE(place_with_room(sheet(), 1, drawing));
    EXPECT_GT(drawn, 1);
}

TEST(RoomForNames, FarNamesComeNearInTheirOrder) {
    std::vector<Name> names{{{50, 160}, "note"}, {{50, 112}, "row"},   {{20, 113}, "same row"}, {{50, 125}, "axis"},
                            {{-40, 50}, "left"}, {{50, 50}, "inside"}, {{50, -30}, "above"},    {{50, 103}, "near"}};
    draw_near(names, 100, 100);
    EXPECT_EQ(names[5].at.y, 50);
    EXPECT_EQ(names[7].at.y, 103) << "it is not moved away";
    EXPECT_GT(names[4].at.x, -10);
    EXPECT_GT(names[6].at.y, -10);
    EXPECT_EQ(names[1].at.y, names[2].at.y);
    // Each row is below the one before it by a line of braille.
    EXPECT_GE(names[1].at.y, names[7].at.y + 9);
    EXPECT_GE(names[3].at.y, names[1].at.y + 10);
    EXPECT_GE(names[0].at.y, names[3].at.y + 10);
    EXPECT_LT(names[0].at.y, 150);
}

}  // namespace
}  // namespace tactics::room_for_names_test
