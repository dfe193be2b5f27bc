// SPDX-License-Identifier: Apache-2.0
// Sizes from the standards that name the papers; widths of lines that a finger can tell.
#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tactics/medium.h"

namespace tactics::papers_and_media_test {
namespace {

TEST(Papers, HaveTheSizesOfTheirStandards) {
    constexpr double kInch = 25.4;
    const Paper expected[] = {{"a3", "", 297, 420},
                              {"a4", "", 210, 297},
                              {"a5", "", 148, 210},
                              {"letter", "", 8.5 * kInch, 11 * kInch},
                              {"legal", "", 8.5 * kInch, 14 * kInch},
                              {"11x11.5", "", 11 * kInch, 11.5 * kInch},
                              {"11x17", "", 11 * kInch, 17 * kInch}};
    EXPECT_EQ(papers().size(), std::size(expected)) << "a new paper is named here with its size";
    for (const Paper& paper : expected) {
        const Paper found = find_paper(paper.name, "test");
        EXPECT_NEAR(found.width, paper.width, 0.01) << paper.name;
        EXPECT_NEAR(found.height, paper.height, 0.01) << paper.name;
    }
}

TEST(Papers, AnySizeIsTurnedUpright) {
    EXPECT_NEAR(find_paper("200x150mm", "test").height, 200, 1e-9);
    EXPECT_NEAR(find_paper("8.5x11in", "test").width, 215.9, 1e-6);
    EXPECT_THROW(find_paper("a44", "test"), Error);
    EXPECT_THROW(find_paper("0x0mm", "test"), Error);
}

TEST(Media, CanBeTold) {
    for (const auto name : {"swell", "plain", "thermoform", "embosser", "floating-dots"}) {
        const Medium& medium = find_medium(name, "test");
        // 0.5 mm is the least line that any guide allows; a gap under 2.5 mm is not felt as one.
        EXPECT_GE(medium.thin_line, 0.5) << name;
        EXPECT_LE(medium.thin_line, medium.line) << name;
        EXPECT_LE(medium.line, medium.thick_line) << name;
        EXPECT_GE(medium.gap, 2.5) << name;
        EXPECT_GE(medium.shortest, medium.line) << name;
    }
    EXPECT_EQ(media().size(), 5u) << "a new medium is named here";
    EXPECT_THROW(find_medium("swel", "test"), Error);
}

// What all standards together allow (SONS, NLS 800, ABA, ADA 703.3).
TEST(Cells, AreThoseOfTheirStandards) {
    for (const auto name : {"marburg-medium", "nls", "aba", "ada"}) {
        const CellSize& size = find_cell(name, "test").size;
        EXPECT_GE(size.dot_pitch, 2.3) << name;
        EXPECT_LE(size.dot_pitch, 2.5) << name;
        EXPECT_GE(size.cell_pitch, 6.0) << name;
        EXPECT_LE(size.cell_pitch, 7.6) << name;
        EXPECT_GE(size.line_pitch, 10.0) << name;
        EXPECT_LE(size.line_pitch, 11.0) << name;
        EXPECT_GE(size.dot, 1.4) << name;
        EXPECT_LT(size.dot, size.dot_pitch - 0.7) << name;  // or the dots of a cell would run together
    }
    EXPECT_EQ(cells().size(), 4u) << "a new cell is named here";
    EXPECT_EQ(cells().front().size.cell_pitch, kMarburgMedium.cell_pitch);
    EXPECT_EQ(cells().front().size.dot, kMarburgMedium.dot);
    EXPECT_THROW(find_cell("nsl", "test"), Error);
}

}  // namespace
}  // namespace tactics::papers_and_media_test
