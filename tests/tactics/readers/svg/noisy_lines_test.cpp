// SPDX-License-Identifier: Apache-2.0
// Time series in SVG: what of their noise a finger can follow.
#include "tactics/readers/svg/noisy_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tactics/readers/svg/figure.h"
#include "tactics/readers/svg/svg.h"

namespace tactics::noisy_lines_test {
namespace {

double hill(double x) { return 60 - 40 * std::exp(-std::pow((x - 120) / 50, 2)); }

// Every millimetre a place, up to 3 mm off the hill; the same for each run.
std::vector<Point> noisy_hill(double most) {
    std::vector<Point> line;
    unsigned state = 7;
    for (int x = 20; x <= 220; ++x) {
        state = state * 1103515245u + 12345u;
        line.push_back({static_cast<double>(x), hill(x) + most * (static_cast<double>(state >> 16 & 0x7fff) / 16384.0 - 1)});
    }
    return line;
}

TEST(NoisyLines, AreFollowedThroughTheirMiddle) {
    const auto noisy = noisy_line(noisy_hill(3));
    ASSERT_TRUE(noisy);
    EXPECT_LT(noisy->course.size(), 150u);
    EXPECT_LT(noisy->course.front().x, 23);
    EXPECT_GT(noisy->course.back().x, 217);
    for (const Point& p : noisy->course) EXPECT_NEAR(p.y, hill(p.x), 3) << p.x;
}

TEST(NoisyLines, SmoothShortAndWindingOnesAreNone) {
    EXPECT_FALSE(noisy_line(noisy_hill(0)));
    EXPECT_FALSE(noisy_line({}));
    std::vector<Point> waves, little = noisy_hill(3), back;
    for (int x = 0; x <= 200; ++x) waves.push_back({static_cast<double>(x), 50 + 20 * std::sin(x / 5.0)});
    EXPECT_FALSE(noisy_line(waves));
    for (Point& p : little) p = {p.x * 0.15, p.y * 0.15};
    EXPECT_FALSE(noisy_line(little)) << "30 mm are a sample of a legend";
    for (int i = 0; i < 200; ++i) back.push_back({20 + 100 * std::abs(std::sin(i / 9.0)), 20 + 0.2 * i});
    EXPECT_FALSE(noisy_line(back));
}

TEST(NoisyLines, OfAFigureAreToldOf) {
    std::string path = "<path fill='none' stroke='black' d='M";
    for (const Point& p : noisy_hill(3)) path += ' ' + std::to_string(p.x) + ' ' + std::to_string(p.y);
    const FoundPage figure = read_svg(
        "<svg xmlns='http://www.w3.org/2000/svg' width='240mm' height='100mm' viewBox='0 0 240 100'>" + path + "'/></svg>",
        "noise.svg", 0, std::nullopt, SvgPurpose::figure);
    const Drawing drawing = drawing_of_figure(figure, 240);
    ASSERT_EQ(drawing.remarks.size(), 1u);
    EXPECT_NE(in_language(drawing.remarks, "en")[0].find("faster than a finger can follow"), std::string::npos);
    ASSERT_FALSE(drawing.strokes.empty());
    EXPECT_LT(total_stroke_length(drawing), 330);
}

}  // namespace
}  // namespace tactics::noisy_lines_test
