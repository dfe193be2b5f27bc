// SPDX-License-Identifier: Apache-2.0
// How large a drawing is, so that its names have room.
#include "tactics/job/room_for_names.h"

#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/place.h"

namespace tactics {
namespace {

Sheet sheet() {
    Sheet sheet;
    sheet.paper = find_paper("a4", "test");
    sheet.medium = &find_medium("swell", "test");
    sheet.braille_table = "en-ueb-g1.ctb";
    return sheet;
}

// Lines over all of the drawing that leave no room for braille, and names at its right side.
Drawing lined(const Rect& place, double names) {
    Drawing drawing;
    drawing.width = place.width;
    drawing.height = place.height;
    for (double y = 0; y <= place.height; y += 6) drawing.strokes.push_back({{{0, y}, {place.width, y}}});
    for (int i = 0; i < names; ++i)
        drawing.names.push_back(
            {{place.width, place.height * (i + 0.5) / names}, std::string(3, static_cast<char>('a' + i)), "test"});
    return drawing;
}

TEST(RoomForNames, WithoutNamesTheDrawingIsAsLargeAsItCanBe) {
    const double widest = place_on(sheet(), 1).drawing.width;
    int drawn = 0;
    const auto found = width_with_room(sheet(), widest, 1, [&](const Sheet&, const Arrangement& on) {
        ++drawn;
        return lined(on.place.drawing, 0);
    });
    ASSERT_TRUE(found);
    EXPECT_EQ(found->width, widest);
    EXPECT_EQ(found->left_out, 0u);
    EXPECT_EQ(drawn, 1);  // no smaller one can be better
}

TEST(RoomForNames, ASmallerDrawingMakesRoomForNamesOutsideOfIt) {
    const double widest = place_on(sheet(), 1).drawing.width;
    const auto found =
        width_with_room(sheet(), widest, 1, [&](const Sheet&, const Arrangement& on) { return lined(on.place.drawing, 8); });
    ASSERT_TRUE(found);
    EXPECT_LT(found->width, widest);
    Sheet narrower = sheet();
    narrower.drawing_width = found->width;
    const Page page = lay_out(lined(place_on(narrower, 1).drawing, 8), narrower);
    EXPECT_EQ(page.names.size(), 8u);
    for (const PageName& name : page.names) EXPECT_TRUE(name.key.empty()) << name.text;
    // Larger ones have no room at all.
    Sheet whole = sheet();
    EXPECT_THROW(lay_out(lined(place_on(whole, 1).drawing, 8), whole), Error);
}

TEST(RoomForNames, NoWidthIsFoundWhereNoneHasRoom) {
    int drawn = 0;
    EXPECT_FALSE(width_with_room(sheet(), 100, 1, [&](const Sheet&, const Arrangement&) -> Drawing {
        ++drawn;
        throw Error(Fault::usage, "test", "no room");
    }));
    EXPECT_GT(drawn, 1);
}

}  // namespace
}  // namespace tactics
