// SPDX-License-Identifier: Apache-2.0
// What a thin line on a slope leaves at deep levels of grey.
#include "tactics/lettering/stroke_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/image.h"

namespace tactics::stroke_steps_test {
namespace {

// A line a pixel wide, `slope` pixels aside for each along, and a stroke as high as a letter beside it.
Image slanting(double slope, bool turned, int from, int to) {
    Image grey = make_image(200, 200, 1, 0, 255);
    for (int y = 0; y < grey.height; ++y)
        for (int x = 0; x < grey.width; ++x) {
            const int along = turned ? x : y, aside = turned ? y : x;
            const double off = std::abs(aside + 0.5 - 60 - slope * along);
            if (along >= from && along < to) grey.row(y)[x] = static_cast<std::uint8_t>(255 * std::clamp(off, 0.0, 1.0));
            if (x >= 150 && x < 153 && y >= 150 && y < 164) grey.row(y)[x] = 0;
        }
    return grey;
}

std::vector<InkPiece> left_of(const Image& grey, std::size_t& before) {
    std::vector<InkPiece> pieces = pieces_of(grey, 96, false, 200);
    before = pieces.size();
    drop_stroke_steps(pieces);
    return pieces;
}

TEST(StrokeSteps, AreNoLetters) {
    for (const bool turned : {false, true})
        for (const double slope : {0.2, 0.31, -0.2}) {
            std::size_t before = 0;
            const std::vector<InkPiece> pieces = left_of(slanting(slope, turned, 0, 200), before);
            ASSERT_GT(before, 10u) << "the line is whole";
            ASSERT_EQ(pieces.size(), 1u) << slope << (turned ? " turned" : "");
            EXPECT_EQ(pieces[0].box.left, 150);
        }
}

TEST(StrokeSteps, AreFourAtLeast) {
    std::size_t before = 0;
    EXPECT_EQ(left_of(slanting(0.2, false, 90, 103), before).size(), before) << "a stroke of an A";
    EXPECT_GT(before, 2u);
    // "__" and a row of l below each other.
    std::vector<InkPiece> rows;
    for (int i = 0; i < 6; ++i) {
        rows.push_back({{10 * i, 50, 10 * i + 9, 52}, {}});
        rows.push_back({{100, 20 * i, 102, 20 * i + 14}, {}});
        rows.push_back({{120 + 4 * i, 60, 122 + 4 * i, 74}, {}});
    }
    drop_stroke_steps(rows);
    EXPECT_EQ(rows.size(), 18u);
}

}  // namespace
}  // namespace tactics::stroke_steps_test
