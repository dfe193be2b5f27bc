// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/moved_off.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tactics/geometry/box.h"
#include "tactics/solid/fold_out.h"
#include "tests/solid/folded.h"
#include "tests/solid/models.h"

namespace tactics::moved_off_test {
namespace {

using namespace tests;

constexpr double kGap = 30;  // mm of the model

struct MovedThings {
    std::vector<ModelPart> parts;
    std::vector<Point3> by;
    std::vector<std::string> name;

    std::size_t of(const std::string& wanted) const {
        return static_cast<std::size_t>(std::find(name.begin(), name.end(), wanted) - name.begin());
    }
    Point3 way(const std::string& wanted) const { return by.empty() ? Point3{} : by[of(wanted)]; }
    Box box(std::size_t part, bool before = false) const {
        Box box = kNothing;
        for (const Patch& patch : parts[part].solid.patches)
            for (const Point3& at : patch.rings.front()) box.take({at.x, at.y});
        const Point3 off = before || by.empty() ? Point3{} : by[part];
        return {box.left + off.x, box.top + off.y, box.right + off.x, box.bottom + off.y};
    }
};

MovedThings moved_things(const Model& model, double gap = kGap, const ViewPlane& view = kFromAbove) {
    std::vector<Phrase> notes;
    MovedThings made;
    made.parts = parts_of(model, {}, {}, notes);
    made.by = moved_off(made.parts, things_of(model, made.parts), view, gap);
    for (const ModelPart& part : made.parts) made.name.push_back(model.objects[part.object].name);
    return made;
}

// mm between two boxes; < 0: how far they overlap.
double room(const Box& a, const Box& b) {
    const double across = std::max(a.left - b.right, b.left - a.right), down = std::max(a.top - b.bottom, b.top - a.bottom);
    return across > 0 && down > 0 ? std::hypot(across, down) : std::max(across, down);
}

double middle(double low, double high) { return (low + high) / 2; }

// A table whose top is 740 high, with boxes that overlap by chance.
Model laid_table(unsigned seed, int count) {
    std::mt19937 engine(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(engine()) / 4294967295.0;
    };
    Model model = table(1600);
    for (int i = 0; i < count; ++i) {
        const double wide = between(60, 160), deep = between(60, 160);
        const double x = (i % 6 - 2.5) * 180 + between(-40, 40), y = (i / 6 - 0.5) * 230 + between(-40, 40);
        add_box(model, "Thing " + std::to_string(i), -1, {x, y, 790}, {wide, deep, 100});
    }
    return model;
}

TEST(MovedOff, ThingsOnATableAreApartOrStayAndKeepTheirOrder) {
    int overlapping = 0, parted = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const MovedThings made = moved_things(laid_table(seed, 12));
        const Box on = made.box(made.of("Top"));
        for (std::size_t i = 0; i < made.parts.size(); ++i) {
            if (made.name[i].rfind("Thing", 0) != 0) continue;
            const Box one = made.box(i), before = made.box(i, true);
            const double far = made.by.empty() ? 0 : length_of(made.by[i]);
            EXPECT_LE(far, kGap + 1e-9) << made.name[i] << ", seed " << seed;
            EXPECT_LE(far, std::min(before.width(), before.height()) / 2 + 1e-9) << made.name[i] << ", seed " << seed;
            EXPECT_GE(std::min({one.left - on.left, on.right - one.right, one.top - on.top, on.bottom - one.bottom}), 0);
            for (std::size_t j = i + 1; j < made.parts.size(); ++j) {
                if (made.name[j].rfind("Thing", 0) != 0) continue;
                const Box other = made.box(j), others = made.box(j, true);
                const double was = room(before, others), is = room(one, other);
                // Nothing comes closer that was too close.
                EXPECT_GE(is, std::min(was, 0.84 * kGap) - 0.03 * kGap) << made.name[i] << ", " << made.name[j] << ", " << seed;
                overlapping += was < 0;
                parted += was < 0 && is > 0.2 * kGap;
                // What was to one side is still there.
                const auto keeps = [&](double low, double high, double other_low, double other_high, double now, double then) {
                    const double order = middle(other_low, other_high) - middle(low, high);
                    return std::abs(order) < 0.11 * kGap || room(before, others) > kGap ||
                           order * (then - now) > -0.03 * kGap * kGap;
                };
                EXPECT_TRUE(keeps(before.left, before.right, others.left, others.right, middle(one.left, one.right),
                                  middle(other.left, other.right)))
                    << made.name[i] << ", " << made.name[j] << ", seed " << seed;
                EXPECT_TRUE(keeps(before.top, before.bottom, others.top, others.bottom, middle(one.top, one.bottom),
                                  middle(other.top, other.bottom)))
                    << made.name[i] << ", " << made.name[j] << ", seed " << seed;
            }
        }
        EXPECT_EQ(length_of(made.way("Top")), 0) << seed;
    }
    EXPECT_GT(overlapping, 10);
    EXPECT_GT(parted, overlapping / 2);
}

// Of pieces so broad that there is no room between them, and of slender ones.
TEST(MovedOff, EachPieceStaysOnItsSquare) {
    constexpr double kSquare = 50;
    for (const double radius : {12.0, 18.0, 22.0, 24.9, 27.0}) {
        Model model;
        add_box(model, "Board", -1, {0, 0, 10}, {8 * kSquare, 8 * kSquare, 20});
        for (int row : {0, 1, 6, 7})
            for (int column = 0; column < 8; ++column)
                add_cylinder(model, "Piece", -1, {(column - 3.5) * kSquare, (row - 3.5) * kSquare, 50}, radius, 60);
        const MovedThings made = moved_things(model);
        for (std::size_t i = 0; i < made.parts.size(); ++i) {
            if (made.name[i] != "Piece") continue;
            const Box before = made.box(i, true), after = made.box(i);
            EXPECT_LT(std::abs(middle(after.left, after.right) - middle(before.left, before.right)), kSquare / 2) << radius;
            EXPECT_LT(std::abs(middle(after.top, after.bottom) - middle(before.top, before.bottom)), kSquare / 2) << radius;
        }
    }
}

TEST(MovedOff, WhatCannotBePartedStaysAndTheRestMoves) {
    Model model = table(1600);
    add_box(model, "Lamp", -1, {-300, 0, 840}, {120, 120, 200});
    add_box(model, "Shade", -1, {-240, 0, 790}, {120, 120, 100});  // they overlap by twice as much as they could move
    add_box(model, "Box", -1, {200, 0, 790}, {100, 100, 100});
    add_box(model, "Book", -1, {310, 0, 750}, {100, 100, 20});
    const MovedThings made = moved_things(model);
    EXPECT_EQ(length_of(made.way("Lamp")), 0);
    EXPECT_EQ(length_of(made.way("Shade")), 0);
    EXPECT_GE(made.box(made.of("Book")).left - made.box(made.of("Box")).right, 0.95 * kGap);
}

TEST(MovedOff, WhatIsApartStaysWhereItIs) {
    Model model = table(1600);
    add_box(model, "Box", -1, {0, 0, 790}, {100, 100, 100});
    add_box(model, "Book", -1, {131, 0, 750}, {100, 100, 20});
    EXPECT_TRUE(moved_things(model).by.empty());
    EXPECT_FALSE(moved_things(model, 40).by.empty());
}

TEST(MovedOff, WhatStandsOnSomethingGoesWithItAndStaysOnIt) {
    Model model = table(1600);
    add_box(model, "Tray", -1, {0, 0, 750}, {400, 300, 20});
    add_cylinder(model, "Cup", -1, {50, 0, 800}, 40, 80);
    add_cylinder(model, "Glass", -1, {-100, 0, 800}, 30, 80);
    add_box(model, "Loaf", -1, {290, 0, 800}, {200, 100, 120});
    const MovedThings made = moved_things(model);
    EXPECT_GE(made.box(made.of("Loaf")).left - made.box(made.of("Tray")).right, 0.95 * kGap);
    EXPECT_NEAR(length_of(made.way("Cup") - made.way("Tray")), 0, 1e-9);
    EXPECT_NEAR(length_of(made.way("Glass") - made.way("Tray")), 0, 1e-9);
    EXPECT_LT(length_of(made.way("Tray")), length_of(made.way("Loaf")));
}

TEST(MovedOff, FurnitureThatTouchesStaysTogetherAndBooksDoNot) {
    Model model;
    add_box(model, "Cupboard", -1, {0, 0, 400}, {600, 500, 800});
    add_box(model, "Stove", -1, {600, 0, 400}, {600, 500, 800});
    EXPECT_TRUE(moved_things(model).by.empty());
    Model books = table(1600);
    add_box(books, "Book", -1, {0, 0, 760}, {200, 300, 40});
    add_box(books, "Dictionary", -1, {200, 0, 780}, {200, 300, 80});
    const MovedThings made = moved_things(books);
    EXPECT_GE(room(made.box(made.of("Book")), made.box(made.of("Dictionary"))), 0.95 * kGap);
}

TEST(MovedOff, AThirdThingPushesNoneOfTwoThatTouchIntoTheOther) {
    Model model;
    add_box(model, "Cupboard", -1, {0, 0, 400}, {600, 500, 800});
    add_box(model, "Stool", -1, {350, 0, 200}, {100, 100, 400});
    add_box(model, "Fridge", -1, {710, 0, 800}, {600, 600, 1600});
    const MovedThings made = moved_things(model);
    if (made.by.empty()) return;
    EXPECT_EQ(length_of(made.way("Cupboard")), 0);
    EXPECT_EQ(length_of(made.way("Stool")), 0);
}

TEST(MovedOff, WhatIsUnderTheTableDoesNotGoWithATrayOnIt) {
    Model model = table(1600);
    add_box(model, "Chair", -1, {0, 380, 220}, {300, 300, 440});
    add_box(model, "Tray", -1, {0, 250, 770}, {600, 380, 20});
    add_box(model, "Loaf", -1, {0, -20, 800}, {300, 150, 80});
    const MovedThings made = moved_things(model);
    ASSERT_FALSE(made.by.empty());
    EXPECT_GT(length_of(made.way("Tray")), 0);
    EXPECT_EQ(length_of(made.way("Chair")), 0);
}

TEST(MovedOff, WhatIsUnderTheTableStaysThere) {
    Model model = table(1600);
    add_box(model, "Pedestal", -1, {500, 0, 300}, {400, 600, 600});
    add_box(model, "Bin", -1, {300, 0, 150}, {200, 200, 300});
    const MovedThings made = moved_things(model);
    EXPECT_EQ(length_of(made.way("Pedestal")), 0);
    EXPECT_EQ(length_of(made.way("Bin")), 0);
}

TEST(MovedOff, SeenFromTheFrontThingsStayOnTheirShelves) {
    Model model;
    const int shelf = add_group(model, "Shelf");
    add_box(model, "Left", shelf, {-510, 0, 400}, {20, 300, 800});
    add_box(model, "Right", shelf, {510, 0, 400}, {20, 300, 800});
    for (const double height : {10.0, 400.0, 790.0}) add_box(model, "Board", shelf, {0, 0, height}, {1000, 300, 20});
    add_box(model, "Book", -1, {0, 0, 120}, {50, 200, 200});
    add_box(model, "Novel", -1, {50, 0, 120}, {50, 200, 200});
    add_box(model, "Box", -1, {20, 0, 500}, {150, 200, 180});
    const MovedThings made = moved_things(model, kGap, kFromTheFront);
    EXPECT_NEAR(made.box(made.of("Novel")).left - made.box(made.of("Book")).right, kGap, 0.05 * kGap);
    for (const Point3& by : made.by) EXPECT_EQ(by.z, 0);
    EXPECT_EQ(length_of(made.way("Box")), 0);
}

TEST(MovedOff, IsToldAndCanBeSwitchedOff) {
    Model model = table(1600);
    add_cylinder(model, "Plate", -1, {0, 0, 750}, 130, 20);
    add_cylinder(model, "Bowl", -1, {200, 0, 770}, 90, 60);
    std::vector<Phrase> notes;
    FoldWish wish;
    const auto moved = [&](const std::string& name) {
        for (const FoldedObject& one : fold_out(model, 170, 240, find_medium("swell", ""), wish, notes).objects)
            if (one.name == name) return one.moved;
        return -1.0;
    };
    EXPECT_GT(moved("Bowl"), moved("Plate"));
    EXPECT_GT(moved("Plate"), 0);
    EXPECT_EQ(moved("Top"), 0);
    wish.move = false;
    EXPECT_EQ(moved("Bowl"), 0);
}

}  // namespace
}  // namespace tactics::moved_off_test
