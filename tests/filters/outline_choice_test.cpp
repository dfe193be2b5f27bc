// SPDX-License-Identifier: Apache-2.0
// Which outlines are drawn within a budget.
#include "filters/outline_choice.h"

#include <gtest/gtest.h>

#include "filters/arc_worth.h"
#include "tests/filters/pictures.h"

namespace tactics::outline_choice_test {
namespace {

RegionTree leaves() {
    Image image = pictures::leaves();
    image.mm_per_pixel = 0.5;
    return std::get<RegionTree>(pictures::filtered("nest map=plain", image));
}

TEST(OutlineChoice, KeepsToItsBudget) {
    const RegionTree tree = leaves();
    const std::vector<float> chances = arc_chances_of(tree).drawn;
    const double all = length_of(tree, best_parts(tree, chances, 0.1, 1e9));
    ASSERT_GT(all, 1000);
    for (const double most : {0.0, all / 4, all / 2}) EXPECT_LE(length_of(tree, best_parts(tree, chances, 0.1, most)), most);
}

// A subject named by a person is drawn whole, regardless of the room on the sheet.
TEST(OutlineChoice, WhatIsDrawnAlreadyStaysWhereNoLineIsLeft) {
    const RegionTree tree = leaves();
    Parts drawn{std::vector<std::uint32_t>(tree.faces(), 0)};
    for (std::size_t f = 0; f < drawn.part.size() / 2; ++f) drawn.part[f] = 1;
    std::vector<float> chances(tree.arcs.size(), 0.9f);
    for (std::size_t i = 0; i < chances.size(); ++i)
        if (drawn.divides(tree.arcs[i])) chances[i] = 1;
    const double length = length_of(tree, drawn);
    const Parts after = more_parts(tree, drawn, chances, 0.5, length / 10);
    EXPECT_EQ(length_of(tree, after), length);
    for (const RegionArc& arc : tree.arcs) EXPECT_EQ(after.divides(arc), drawn.divides(arc));
}

}  // namespace
}  // namespace tactics::outline_choice_test
