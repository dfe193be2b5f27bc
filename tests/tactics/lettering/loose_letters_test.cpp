// SPDX-License-Identifier: Apache-2.0
// Letters that touch a line of a drawing, and what else does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/course.h"
#include "tactics/lettering/read_line.h"

namespace tactics::loose_letters_test {
namespace {

// Other words of the picture, with letters 20 pixels high.
std::vector<ReadLine> words(std::size_t count) {
    std::vector<ReadLine> lines(count);
    for (ReadLine& one : lines) {
        one.line.level = 128;
        one.line.letter_height = 20;
        one.words.sure = true;
    }
    return lines;
}

void stroke(Image& grey, const std::vector<Point>& points, double width = 2.4) {
    for (int y = 0; y < grey.height; ++y)
        for (int x = 0; x < grey.width; ++x)
            for (std::size_t i = 1; i < points.size(); ++i)
                if (distance_to_segment({x + 0.5, y + 0.5}, points[i - 1], points[i]) <= width / 2) grey.row(y)[x] = 0;
}

Image with_line() {
    Image grey = make_image(240, 120, 1, 0, 255);
    stroke(grey, {{5, 90}, {235, 90}});
    return grey;
}

// An R whose feet are on the line.
void draw_letter(Image& grey, double left) {
    stroke(grey, {{left, 90}, {left, 70}, {left + 9, 70}, {left + 12, 75}, {left + 9, 80}, {left, 80}});
    stroke(grey, {{left + 6, 80}, {left + 13, 90}});
}

TEST(LooseLetters, ThatTouchALineAreFound) {
    Image grey = with_line();
    draw_letter(grey, 100);
    const std::vector<LetteringLine> found = loose_letters(grey, words(2));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].box.left, 99, 2);
    EXPECT_NEAR(found[0].box.top, 69, 2);
    EXPECT_NEAR(found[0].box.right, 114, 3);
    draw_letter(grey, 120);
    const std::vector<LetteringLine> two = loose_letters(grey, words(2));
    ASSERT_EQ(two.size(), 1u) << "two of one label";
    EXPECT_EQ(two[0].letters.size(), 2u);
    EXPECT_TRUE(loose_letters(grey, words(1)).empty()) << "who knows how large print is?";
}

TEST(LooseLetters, AreNoHeadsRingsBarsOrTextures) {
    Image head = with_line();
    for (const double side : {-1.0, 1.0})
        for (double t = 0; t <= 1; t += 0.1) stroke(head, {{120, 90}, {120 + side * 10 * t, 104 + 7 * t}}, 1.5);
    EXPECT_TRUE(loose_letters(head, words(2)).empty()) << "a filled head";
    Image ring = with_line();
    std::vector<Point> circle;
    for (int i = 0; i <= 24; ++i) circle.push_back({120 + 9 * std::cos(i * 0.2618), 80 + 9 * std::sin(i * 0.2618)});
    stroke(ring, circle);
    EXPECT_TRUE(loose_letters(ring, words(2)).empty());
    Image tick = with_line();
    stroke(tick, {{120, 90}, {120, 72}});
    EXPECT_TRUE(loose_letters(tick, words(2)).empty());
    Image texture = with_line();
    for (int i = 0; i < 7; ++i) draw_letter(texture, 10 + 32.0 * i);
    EXPECT_TRUE(loose_letters(texture, words(2)).empty());
}

}  // namespace
}  // namespace tactics::loose_letters_test
