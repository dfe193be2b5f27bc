// SPDX-License-Identifier: Apache-2.0
// What is printed over a grid is as if the grid were not there.
#include "tactics/lettering/pale_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace tactics::pale_lines_test {
namespace {

// Ink lets through what is below it, as in a picture that is printed over another.
void print_over(Image& image, int x, int y, int grey) {
    std::uint8_t& pixel = image.row(y)[x];
    pixel = static_cast<std::uint8_t>(pixel * grey / 255);
}

void add_box(Image& image, int left, int top, int right, int bottom, int grey) {
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) print_over(image, x, y, grey);
}

// Strokes with soft edges on places where the lines will be.
Image letters() {
    Image image = make_image(300, 200, 1, 0, 255);
    for (const int left : {95, 145, 195}) {
        add_box(image, left, 90, left + 10, 91, 130);
        add_box(image, left, 91, left + 10, 93, 0);
        add_box(image, left + 4, 93, left + 5, 110, 110);
        add_box(image, left + 5, 93, left + 7, 110, 20);
    }
    return image;
}

int most_apart(const Image& a, const Image& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) most = std::max(most, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
    return most;
}

TEST(PaleLines, AreTakenOutBehindPrint) {
    for (const int grey : {120, 170, 220}) {
        Image image = letters();
        for (const int x : {50, 100, 150, 200}) {
            add_box(image, x, 0, x + 1, 200, grey);
            add_box(image, x + 1, 0, x + 2, 200, (grey + 255) / 2);  // it lies on two pixels
        }
        add_box(image, 0, 100, 300, 101, grey);
        EXPECT_LE(most_apart(without_pale_lines(image), letters()), 4) << grey;
    }
}

TEST(PaleLines, DarkLinesShortOnesAndSurfacesStay) {
    Image image = letters();
    add_box(image, 30, 0, 32, 200, 0);                                           // an axis
    add_box(image, 60, 20, 61, 60, 170);                                         // a stroke of pale print
    add_box(image, 220, 20, 290, 180, 200);                                      // a panel
    for (int x = 20; x < 200; x += 12) add_box(image, x, 150, x + 4, 151, 248);  // what fades from small print
    EXPECT_EQ(without_pale_lines(image).pixels, image.pixels);
    Image dark = image;
    for (std::uint8_t& pixel : dark.pixels) pixel = static_cast<std::uint8_t>(255 - pixel);
    EXPECT_EQ(without_pale_lines(dark).pixels, dark.pixels);
    const Image tiny = make_image(3, 2, 1, 0, 255);
    EXPECT_EQ(without_pale_lines(tiny).pixels, tiny.pixels);
}

}  // namespace
}  // namespace tactics::pale_lines_test
