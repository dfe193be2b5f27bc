// SPDX-License-Identifier: Apache-2.0
// What a thin ring leaves at deep levels of grey.
#include "tactics/lettering/stroke_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/lettering/lines.h"

namespace tactics::stroke_parts_test {
namespace {

// A node of a graph: a ring a pixel wide with a T in it, dark on light or the other way round.
Image node(int ground, double radius) {
    Image grey = make_image(200, 200, 1, 0, 255);
    for (int y = 0; y < grey.height; ++y)
        for (int x = 0; x < grey.width; ++x) {
            const double off = std::abs(std::hypot(x + 0.5 - 100.3, y + 0.5 - 100.2) - radius);
            const bool letter = (y >= 93 && y < 95 && x >= 95 && x < 105) || (y >= 93 && y < 107 && x >= 99 && x < 101);
            const double ink = letter ? 1 : std::clamp(1.05 - off, 0.0, 1.0);
            grey.row(y)[x] = static_cast<std::uint8_t>(std::lround(ground + (255 - 2 * ground) * ink));
        }
    return grey;
}

TEST(StrokeParts, OfARingAreNoLetters) {
    for (const int ground : {255, 0})
        for (const double radius : {24.0, 40.0, 90.0}) {
            const Image grey = node(ground, radius);
            const bool light = ground == 0;
            const int level = light ? 207 : 48;
            std::vector<InkPiece> pieces = pieces_of(grey, level, light, 200);
            ASSERT_GT(pieces.size(), 5u) << "the ring is whole";
            drop_stroke_parts(grey, level, light, pieces);
            std::erase_if(pieces, [](const InkPiece& piece) { return piece.box.width() < 5 && piece.box.height() < 5; });
            ASSERT_EQ(pieces.size(), 1u) << ground << " " << radius;
            EXPECT_EQ(pieces[0].box.left, 95);
        }
}

TEST(StrokeParts, ALetterIsFoundInItsRing) {
    for (const double radius : {24.0, 40.0}) {
        const std::vector<LetteringLine> lines = find_lettering(node(255, radius));
        EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                                [](const LetteringLine& line) { return line.box.left == 95 && line.box.right == 105; }),
                  1)
            << radius;
    }
}

// An l beside one another, and the stem of a letter that comes apart.
TEST(StrokeParts, ALetterByItselfIsNone) {
    Image grey = make_image(80, 40, 1, 0, 255);
    for (int y = 10; y < 30; ++y) {
        grey.row(y)[20] = grey.row(y)[21] = 0;
        grey.row(y)[40] = 0;
        grey.row(y)[50] = 0;
        if (y == 10 || y == 20)
            for (int x = 41; x < 50; ++x) grey.row(y)[x] = 120;
    }
    std::vector<InkPiece> pieces = pieces_of(grey, 64, false, 200);
    ASSERT_EQ(pieces.size(), 3u);
    drop_stroke_parts(grey, 64, false, pieces);
    EXPECT_EQ(pieces.size(), 3u);
}

}  // namespace
}  // namespace tactics::stroke_parts_test
