// SPDX-License-Identifier: Apache-2.0
// What a folded model tells of its objects agrees with its drawing.
#include "tactics/solid/object_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tactics/geometry/box.h"
#include "tactics/solid/fold_out.h"
#include "tests/solid/models.h"

namespace tactics::object_regions_test {
namespace {

using namespace tests;

FoldOut folded(const Model& model, const FoldWish& wish = {}) {
    std::vector<Phrase> notes;
    return fold_out(model, 180, 250, find_medium("swell", "test"), wish, notes);
}

// A table with a cup on it, a chair beside it, and a pin that no finger finds.
Model scene() {
    Model model = table(1200);
    add_cylinder(model, "Cup", -1, {100, 100, 790}, 60, 100);
    add_box(model, "OB_Chair_001", -1, {1000, 0, 225}, {450, 450, 450});
    add_box(model, "Pin", -1, {0, -200, 741}, {2, 2, 2});
    return model;
}

const Region* find(const FoldOut& made, const std::string& path) {
    for (const Region& region : made.drawing.regions)
        if (region.path == path) return &region;
    return nullptr;
}

std::size_t place_of(const FoldOut& made, const std::string& path) {
    return static_cast<std::size_t>(find(made, path) - made.drawing.regions.data());
}

TEST(ObjectRegions, EveryDrawnObjectLiesInItsRegionAndTheOthersAreTold) {
    const FoldOut made = folded(scene());
    ASSERT_EQ(made.drawing.regions.size(), made.objects.size());
    std::multiset<std::string> drawn;
    for (const Region& region : made.drawing.regions)
        if (!region.rings.empty()) drawn.insert(region.path);
    for (const FoldedObject& one : made.objects) {
        const bool is_drawn = one.fate == FoldedObject::Fate::drawn;
        EXPECT_EQ(drawn.count(one.path) > 0, is_drawn) << one.path;
        if (!is_drawn) continue;
        EXPECT_TRUE(std::any_of(made.drawing.regions.begin(), made.drawing.regions.end(), [&](const Region& region) {
            return region.path == one.path && holds(region, one.at) && holds(region, region.at);
        })) << one.path;
    }
    EXPECT_EQ(find(made, "Pin")->description.english(), "too small to be felt at this size");
    EXPECT_EQ(find(made, "OB_Chair_001")->name, "Chair");
}

TEST(ObjectRegions, AllThatIsDrawnLiesInSomeRegion) {
    const FoldOut made = folded(scene());
    for (const Stroke& stroke : made.drawing.strokes)
        for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
            const Point a = stroke.points[i], b = stroke.points[i + 1], middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
            // On its border, so beside it on one side or the other.
            constexpr double kBeside = 0.05;
            const double length = std::max(distance(a, b), 1e-9);
            const Point aside{-(b.y - a.y) / length * kBeside, (b.x - a.x) / length * kBeside};
            EXPECT_TRUE(std::any_of(made.drawing.regions.begin(), made.drawing.regions.end(),
                                    [&](const Region& region) {
                                        return holds(region, {middle.x + aside.x, middle.y + aside.y}) ||
                                               holds(region, {middle.x - aside.x, middle.y - aside.y});
                                    }))
                << middle.x << " " << middle.y;
        }
}

TEST(ObjectRegions, WhatLiesOnTopIsHitFirst) {
    const FoldOut made = folded(scene());
    ASSERT_NE(find(made, "Cup"), nullptr);
    EXPECT_GT(place_of(made, "Cup"), place_of(made, "Table/Top"));
    EXPECT_FALSE(holds(*find(made, "OB_Chair_001"), find(made, "Cup")->at));
}

TEST(ObjectRegions, WhatWasDoneIsSaidAndCounted) {
    const FoldOut made = folded(scene());
    EXPECT_EQ(find(made, "Table/Top")->description.english(), "seen from above; 4 slender parts on it laid flat outward");
    EXPECT_EQ(find(made, "Table/Leg")->description.english(), "laid flat outward");
    for (const Region& region : made.drawing.regions)
        for (const auto& [what, count] : region.counts) {
            EXPECT_GT(count, 0);
            // Clang 14 cannot capture structured bindings in lambdas.
            const auto one = std::find_if(made.objects.begin(), made.objects.end(),
                                          [&, what = what, count = count](const FoldedObject& object) {
                                              return object.path == region.path && what == "folded" && object.folded == count;
                                          });
            EXPECT_TRUE(what != "folded" || one != made.objects.end());
        }
    Model cube;
    add_box(cube, "Cube", -1, {0, 0, 50}, {100, 100, 100});
    const FoldOut cross = folded(cube);
    EXPECT_EQ(cross.drawing.regions.front().description.english().substr(0, 35), "seen from above; 4 faces folded out");
    const bool dashed = std::any_of(cross.drawing.strokes.begin(), cross.drawing.strokes.end(),
                                    [](const Stroke& stroke) { return stroke.role == Role::dash; });
    EXPECT_EQ(cross.objects.front().doubled > 0, dashed);
    EXPECT_EQ(cross.drawing.remarks.size() > 1, dashed);
}

TEST(ObjectRegions, ALegIsWideEnoughForAFinger) {
    const FoldOut made = folded(scene());
    const Box box = box_of(*find(made, "Table/Leg"));
    EXPECT_GE(std::min(box.width(), box.height()), 6.35 - 1e-9);
}

TEST(ObjectRegions, TheyAreReadFromTheTopButWhatLiesOnOthersLater) {
    const auto square = [](const std::string& name, double left, double top) {
        return Region{
            name, "", "", {}, {{{left, top}, {left + 30, top}, {left + 30, top + 30}, {left, top + 30}}}, {left + 15, top + 15}};
    };
    const std::vector<Region> read = in_reading_order({square("low", 0, 100),
                                                       {"gone", "", "", {}, {}, {}},
                                                       square("on it", 10, 90),
                                                       square("right", 50, 0),
                                                       square("left", 0, 0)},
                                                      {0, 0, 5, 9, 1});
    std::string names;
    for (const Region& region : read) names += region.name.english() + ", ";
    EXPECT_EQ(names, "left, right, low, on it, gone, ");
}

}  // namespace
}  // namespace tactics::object_regions_test
