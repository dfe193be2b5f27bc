// SPDX-License-Identifier: Apache-2.0
// What is worth drawing: pages that the stakes lead to beside those of every price, and what they do with clear and unclear
// pictures.
#include "filters/page_stakes.h"

#include <gtest/gtest.h>

#include <limits>

#include "filters/outline_choice.h"
#include "tests/filters/pictures.h"

namespace tactics::page_stakes_test {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

RegionTree tree_of(const Image& image) { return std::get<RegionTree>(pictures::filtered("nest map=plain", image)); }

Parts page_of(const RegionTree& tree, const ArcChances& chances, double sure) {
    const Stakes stakes = stakes_of(tree, chances, sure);
    return best_parts(tree, stakes.worth, stakes.price, kNoLimit);
}

// As the header says it; 0 if nothing is drawn.
double expected_good(const RegionTree& tree, const Parts& parts, const ArcChances& chances, double sure) {
    double length = 0, agreed = 0, all_agreed = 0, main = 0, all_main = 0.7 * std::hypot(tree.width, tree.height);
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const double steps = steps_of(tree.arcs[i]), of_agreed = steps * chances.drawn[i], of_main = steps * chances.main[i];
        all_agreed += of_agreed;
        all_main += of_main;
        if (!parts.divides(tree.arcs[i])) continue;
        length += steps;
        agreed += of_agreed;
        main += of_main;
    }
    return length > 0 ? sure * agreed / length + (1 - sure) * (0.6 * agreed / all_agreed + 0.4 * main / all_main) : 0;
}

// Two discs on plain ground.
Image two_shades() {
    Image image = pictures::drawn(480, 320, [](int x, int y) {
        return std::hypot(x - 120, y - 160) < 70 ? 40 : std::hypot(x - 350, y - 160) < 70 ? 230 : 130;
    });
    image.mm_per_pixel = 0.5;
    return image;
}

RegionTree two_discs() { return tree_of(two_shades()); }

// Arcs that bound the disc on the left, and those on the right, are as likely as told; others are not likely.
ArcChances chances_of_discs(const RegionTree& tree, float left, float right) {
    ArcChances chances{std::vector<float>(tree.arcs.size(), 0.01f), std::vector<float>(tree.arcs.size(), 0.0f)};
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const Point at = tree.arcs[i].points[tree.arcs[i].points.size() / 2];
        for (const auto& [x, chance] : {std::pair(120.0, left), std::pair(350.0, right)})
            if (tree.arcs[i].level > 0 && std::abs(std::hypot(at.x - x, at.y - 160) - 70) < 6) chances.drawn[i] = chance;
    }
    return chances;
}

double drawn_at(const RegionTree& tree, const Parts& parts, double x) {
    double length = 0;
    for (const RegionArc& arc : tree.arcs)
        if (const Point at = arc.points[arc.points.size() / 2];
            parts.divides(arc) && std::abs(std::hypot(at.x - x, at.y - 160) - 70) < 6)
            length += steps_of(arc);
    return length;
}

TEST(PageStakes, WhatIsLikelyEnoughAloneIsNotBesideWhatIsSure) {
    const RegionTree tree = two_discs();
    const Parts unclear = page_of(tree, chances_of_discs(tree, 0.5f, 0.5f), 0.7);
    EXPECT_GT(drawn_at(tree, unclear, 120), 300);
    EXPECT_GT(drawn_at(tree, unclear, 350), 300);
    const Parts clear = page_of(tree, chances_of_discs(tree, 0.98f, 0.3f), 0.7);
    EXPECT_GT(drawn_at(tree, clear, 120), 300);
    EXPECT_EQ(drawn_at(tree, clear, 350), 0);
}

TEST(PageStakes, WhoWantsAllGetsMoreThanWhoWantsToBeSure) {
    const RegionTree tree = two_discs();
    const ArcChances chances = chances_of_discs(tree, 0.95f, 0.5f);
    EXPECT_EQ(drawn_at(tree, page_of(tree, chances, 0.95), 350), 0);
    EXPECT_GT(drawn_at(tree, page_of(tree, chances, 0.3), 350), 300);
}

TEST(PageStakes, TheMainThingGoesBeforeAnotherThatIsAsLikely) {
    const RegionTree tree = two_discs();
    ArcChances chances = chances_of_discs(tree, 0.6f, 0.6f);
    for (std::size_t i = 0; i < tree.arcs.size(); ++i)
        if (tree.arcs[i].points.front().x < 240 && chances.drawn[i] > 0.5f) chances.main[i] = 0.6f;
    const Stakes stakes = stakes_of(tree, chances, 0.6);
    const Parts parts = best_parts(tree, stakes.worth, stakes.price, 700);
    EXPECT_GT(drawn_at(tree, parts, 120), 300);
    EXPECT_EQ(drawn_at(tree, parts, 350), 0);
}

// Among pages with as much line as A4 has, none for another price is much better; with fitted probabilities. (A request for much
// more line than usual may get less than the best: there the slope leads to the nearest maximum.)
TEST(PageStakes, LeadToAboutTheBestPage) {
    for (Image image : {pictures::leaves(), two_shades()}) {
        image.mm_per_pixel = 0.5;
        const RegionTree tree = tree_of(image);
        const ArcChances chances = arc_chances_of(tree);
        const double most = 4.5 * std::hypot(tree.width, tree.height);
        for (const double sure : {0.62, 0.7, 0.8}) {
            const double good = expected_good(tree, page_of(tree, chances, sure), chances, sure);
            for (double price = 0.1; price < 1; price += 0.05)
                EXPECT_LT(expected_good(tree, best_parts(tree, chances.drawn, price, most), chances, sure), good + 0.05)
                    << sure << " " << price;
        }
    }
}

TEST(PageStakes, NothingIsWorthDrawingWhereNothingIs) {
    Image image = pictures::drawn(480, 320, [](int, int) { return 200; });
    image.mm_per_pixel = 0.5;
    const RegionTree tree = tree_of(image);
    EXPECT_EQ(length_of(tree, page_of(tree, arc_chances_of(tree), 0.6)), 0);
}

}  // namespace
}  // namespace tactics::page_stakes_test
