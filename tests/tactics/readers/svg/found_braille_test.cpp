// SPDX-License-Identifier: Apache-2.0
// Braille known again from its dots.
#include "tactics/readers/svg/found_braille.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/rules/pages.h"

namespace tactics::found_braille_test {
namespace {

using namespace tests;

std::vector<Disc> discs_of(const BrailleLine& line, const CellSize& cell, double diameter) {
    std::vector<Disc> discs;
    for (const Point& p : dots_of(line, cell)) discs.push_back({p, diameter});
    return discs;
}

// Any text in any of the cells that are in use, three lines and a label beside them that is out of step.
TEST(FoundBraille, IsWhatWasSet) {
    Dice chance(1);
    for (const CellSize& cell :
         {CellSize{2.5, 6, 10}, CellSize{2.34, 6.2, 10}, CellSize{2.5, 6.35, 10.16}, CellSize{2.2, 5.38, 8.46}})
        for (int round = 0; round < 30; ++round) {
            std::vector<BrailleLine> lines;
            for (int i = 0; i < 3; ++i) {
                BrailleLine line{{20, 30 + i * cell.line_pitch}, {}};
                for (std::size_t k = 0; k < 12; ++k)
                    line.cells.push_back(k % 5 == 4 ? 0 : static_cast<std::uint8_t>(1 + chance.below(63)));
                line.cells[0] = line.cells[11] = 0x3f;
                lines.push_back(line);
            }
            lines.push_back({{150.7, 43.3}, {0x3f, 0x15, 0x3f}});
            Page page = blank_page();
            std::vector<Disc> discs;
            for (const BrailleLine& line : lines)
                for (const Disc& disc : discs_of(line, cell, 1.5)) discs.push_back(disc);
            const auto left = take_braille(discs, page);
            EXPECT_TRUE(left.empty());
            EXPECT_NEAR(page.cell.dot_pitch, cell.dot_pitch, 1e-6);
            EXPECT_NEAR(page.cell.cell_pitch, cell.cell_pitch, 1e-6);
            ASSERT_EQ(page.braille.size(), lines.size());
            for (const BrailleLine& line : lines) {
                const auto same = std::find_if(page.braille.begin(), page.braille.end(), [&](const BrailleLine& other) {
                    return distance(other.first_dot, line.first_dot) < 1e-6 && other.cells == line.cells;
                });
                EXPECT_NE(same, page.braille.end());
            }
        }
}

// Two letters beside two others at any other height and distance, as keys on a drawing stand.
TEST(FoundBraille, IsKnownBesideOthersOutOfStep) {
    Dice chance(3);
    const CellSize cell;
    int known = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<BrailleLine> lines;
        for (int i = 0; i < 3; ++i) {
            BrailleLine line{{20 + i * chance.between(14.5, 19), 30 + chance.between(-6, 6)}, {}};
            for (std::size_t k = 0; k < 2; ++k) line.cells.push_back(static_cast<std::uint8_t>(9 | chance.below(64)));
            lines.push_back(line);
        }
        Page page = blank_page();
        std::vector<Disc> discs;
        for (const BrailleLine& line : lines)
            for (const Disc& disc : discs_of(line, cell, 1.5)) discs.push_back(disc);
        take_braille(discs, page);
        const bool all = std::all_of(lines.begin(), lines.end(), [&](const BrailleLine& line) {
            return std::any_of(page.braille.begin(), page.braille.end(), [&](const BrailleLine& other) {
                return distance(other.first_dot, line.first_dot) < 1e-6 && other.cells == line.cells;
            });
        });
        known += all ? 1 : 0;
    }
    EXPECT_GE(known, 180) << "what is in step by chance may be taken for one";
}

TEST(FoundBraille, IsNotADottedLineOrASprinkleOfDots) {
    Page page = blank_page();
    std::vector<Disc> dotted;
    for (int i = 0; i < 20; ++i) dotted.push_back({{20 + 2.5 * i, 50}, 1.5});
    EXPECT_EQ(take_braille(dotted, page).size(), 20u);
    Dice chance(2);
    std::vector<Disc> sprinkle;
    for (int i = 0; i < 200; ++i) sprinkle.push_back({{chance.between(0, 200), chance.between(0, 200)}, 1.5});
    EXPECT_GT(take_braille(sprinkle, page).size(), 190u) << "here and there two dots stand as in a cell";
    std::vector<Disc> texture;
    for (int i = 0; i < 400; ++i) texture.push_back({{20.0 + 3 * (i % 20), 20.0 + 3 * (i / 20)}, 1.5});
    EXPECT_EQ(take_braille(texture, page).size(), 400u);
    EXPECT_EQ(take_braille({}, page).size(), 0u);
    EXPECT_EQ(take_braille({{{5, 5}, 1.5}}, page).size(), 1u);
}

TEST(FoundBraille, DotsAreSmallRoundRings) {
    Disc disc;
    EXPECT_TRUE(is_braille_dot(circle({5, 6}, 0.8, 32), disc));
    EXPECT_NEAR(disc.diameter, 1.6, 1e-9);
    EXPECT_FALSE(is_braille_dot(circle({5, 6}, 5, 32), disc));
    EXPECT_FALSE(is_braille_dot(rectangle(5, 6, 1.6, 1.6), disc));
    std::vector<Point> oval = circle({0, 0}, 0.8, 32);
    for (Point& p : oval) p.x *= 1.4;
    EXPECT_FALSE(is_braille_dot(oval, disc));
}

// A page of 297 mm as a figure, which is 200 mm high.
FoundPage figure_with(const std::vector<Disc>& discs) {
    constexpr double kScale = 200.0 / 297;
    FoundPage figure;
    figure.file_width = 210;
    figure.file_height = 297;
    figure.page.width = 210 * kScale;
    figure.page.height = 200;
    for (const Disc& disc : discs) {
        figure.looks.push_back({0, 0, figure.page.areas.size(), figure.page.areas.size() + 1});
        const Point middle{disc.middle.x * kScale, disc.middle.y * kScale};
        figure.page.areas.push_back({{circle(middle, disc.diameter / 2 * kScale, 32)}, Role::line});
    }
    return figure;
}

TEST(FoundBraille, OfAFigureIsTakenOutAndItsPointsStay) {
    const BrailleLine title{{20, 15}, {0x13, 0x15, 0x07, 0, 0x0b, 0x11, 0x1d}};
    std::vector<Disc> discs{{{50, 100}, 5}};
    for (const Disc& disc : discs_of(title, CellSize{2.5, 6, 10}, 1.5)) discs.push_back(disc);
    discs.push_back({{70, 130}, 5});
    FoundPage figure = figure_with(discs);
    take_braille_of_figure(figure);
    ASSERT_EQ(figure.page.braille.size(), 1u);
    EXPECT_EQ(figure.page.braille[0].cells, title.cells);
    ASSERT_EQ(figure.page.areas.size(), 2u);
    const FoundLook &first = figure.looks.front(), &braille = figure.looks[1], &last = figure.looks.back();
    EXPECT_EQ(std::pair(first.area, first.areas_end), std::pair(std::size_t{0}, std::size_t{1}));
    EXPECT_EQ(braille.area, braille.areas_end) << "its dots are gone";
    EXPECT_EQ(std::pair(last.area, last.areas_end), std::pair(std::size_t{1}, std::size_t{2}));
}

TEST(FoundBraille, PointsOfAPlotAreNone) {
    Dice chance(4);
    for (int round = 0; round < 40; ++round) {
        std::vector<Disc> points, rows, columns;
        for (int i = 0; i < 150; ++i) {
            points.push_back({{chance.between(20, 190), chance.between(20, 270)}, 1.5});
            rows.push_back({{20 + 2.5 * (i % 15), 30 + 2.5 * static_cast<double>(chance.below(60))}, 1.5});  // whole numbers
        }
        for (int i = 0; i < 50; ++i) {
            const double speed = static_cast<double>(chance.below(22)), spread = static_cast<double>(chance.below(30));
            columns.push_back({{20 + 5.33 * speed, 240 - 0.53 * 2 * (2 * speed + spread)}, 1.9});
        }
        for (const auto& discs : {points, rows, columns}) {
            FoundPage figure = figure_with(discs);
            take_braille_of_figure(figure);
            EXPECT_EQ(figure.page.areas.size(), discs.size()) << "round " << round;
        }
    }
}

}  // namespace
}  // namespace tactics::found_braille_test
