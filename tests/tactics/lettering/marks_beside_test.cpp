// SPDX-License-Identifier: Apache-2.0
// Swatches and dots beside words are no letters; letters are, however solid.
#include "tactics/lettering/marks_beside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tactics::marks_beside_test {
namespace {

using Parts = std::vector<std::vector<std::size_t>>;

class Line {
public:
    void box(int left, int top, int right, int bottom, bool solid) {
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x)
                if (solid || x == left || y == top || x == right - 1 || y == bottom - 1) image_.row(y)[x] = 0;
    }
    void disc(int left, int top, int side) {
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double dx = x + 0.5 - side / 2.0, dy = y + 0.5 - side / 2.0;
                if (4 * (dx * dx + dy * dy) <= side * side) image_.row(top + y)[left + x] = 0;
            }
    }
    // As an arrow to the right has it.
    void head(int left, int top, int side) {
        for (int x = 0; x < side; ++x)
            for (int y = x / 2; y < side - x / 2; ++y) image_.row(top + y)[left + x] = 0;
    }
    // As an L is.
    void letter(int left) {
        box(left, 10, left + 2, 24, true);
        box(left, 22, left + 8, 24, true);
    }
    std::vector<InkPiece> pieces() const {
        std::vector<InkPiece> found = pieces_of(image_, 128, false, 100);
        std::sort(found.begin(), found.end(), [](const InkPiece& a, const InkPiece& b) { return a.box.left < b.box.left; });
        return found;
    }

private:
    Image image_ = make_image(160, 40, 1, 0, 255);
};

Parts parts_of(const Line& line) {
    const std::vector<InkPiece> pieces = line.pieces();
    std::vector<PixelBox> boxes;
    std::vector<std::size_t> letters;
    for (const InkPiece& piece : pieces) {
        letters.push_back(boxes.size());
        boxes.push_back(piece.box);
    }
    return parts_at_marks(pieces, boxes, letters);
}

TEST(MarksBeside, SwatchesDotsAndSamplesAreCutOff) {
    for (const std::string mark : {"solid", "frame", "disc", "sample", "head"}) {
        Line line;
        if (mark == "disc")
            line.disc(10, 12, 10);
        else if (mark == "head")
            line.head(10, 12, 12);
        else
            line.box(10, 12, mark == "sample" ? 45 : 22, 24, mark != "frame");
        for (const int left : {52, 64, 76}) line.letter(left);
        EXPECT_EQ(parts_of(line), (Parts{{0}, {1, 2, 3}})) << mark;
    }
}

TEST(MarksBeside, MayStandBetweenTwoNames) {
    Line line;
    line.box(4, 12, 16, 24, true);
    line.letter(22), line.letter(34);
    line.box(50, 12, 62, 24, true);
    line.letter(68), line.letter(80);
    EXPECT_EQ(parts_of(line), (Parts{{0}, {1, 2}, {3}, {4, 5}}));
}

TEST(MarksBeside, LettersAreNone) {
    Line stems;
    stems.letter(10), stems.box(24, 10, 27, 24, true), stems.letter(34);  // an l
    EXPECT_EQ(parts_of(stems), (Parts{{0, 1, 2}}));
    Line near;  // a filled letter of a word
    near.letter(10), near.box(20, 12, 30, 24, true), near.letter(32);
    EXPECT_EQ(parts_of(near), (Parts{{0, 1, 2}}));
    Line small;  // an n of few pixels
    small.letter(10), small.box(26, 18, 31, 20, true), small.box(26, 20, 28, 24, true), small.box(29, 20, 31, 24, true);
    small.letter(38);
    EXPECT_EQ(parts_of(small), (Parts{{0, 1, 2}}));
    Line marks;  // of a plot
    for (const int left : {10, 30, 50, 70}) marks.disc(left, 12, 10);
    EXPECT_EQ(parts_of(marks), (Parts{{0, 1, 2, 3}}));
}

TEST(MarksBeside, ANodeIsInTheMiddleAndLargerThanAPoint) {
    const PixelBox line{0, 10, 60, 24};
    const auto is = [&](int top, int side) {
        Line dot;
        dot.disc(70, top, side);
        const InkPiece piece = dot.pieces().front();
        return is_node(piece, piece.box, line);
    };
    EXPECT_TRUE(is(14, 7));
    const PixelBox reaching_down{0, -5, 60, 44};  // "Corby"
    Line town;
    town.disc(70, 10, 19);
    EXPECT_TRUE(is_node(town.pieces().front(), town.pieces().front().box, reaching_down)) << "a point of a map before its name";
    EXPECT_FALSE(is(14, 5)) << "a point of a product";
    EXPECT_FALSE(is(18, 6)) << "a full stop of heavy print";
    EXPECT_FALSE(is(9, 6)) << "a sign of degrees that is filled";
}

}  // namespace
}  // namespace tactics::marks_beside_test
