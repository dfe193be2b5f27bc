// SPDX-License-Identifier: Apache-2.0
// Line styles: what a finger tells them by is there in samples, in long lines and in short pieces.
#include "tactics/geometry/line_styles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "tactics/geometry/course.h"
#include "tactics/geometry/shape.h"
#include "tactics/page.h"

namespace tactics::line_styles_test {
namespace {

constexpr const char* kMedia[] = {"swell", "thermoform", "embosser", "floating-dots"};

std::vector<Point> wave(double length, double high) {
    std::vector<Point> line;
    for (int i = 0; i <= 300; ++i) line.push_back({i * length / 300, 50 + high * std::sin(i * 0.05)});
    return line;
}

// What is felt: width, and of marks their lengths in the order in which they come, as dots or dashes.
std::string felt(const std::vector<Stroke>& strokes, const Medium& medium) {
    std::string form =
        std::to_string(width_of(strokes[0].line, medium)) + (strokes[0].role == Role::dash ? " dashed " : " whole ");
    for (std::size_t i = 0; i < std::min<std::size_t>(strokes.size(), 3) && strokes[i].role == Role::dash; ++i)
        form += length_of(strokes[i]) < 0.5 ? '.' : '-';
    return form;
}

TEST(LineStyles, FiveThatDifferOnEveryMedium) {
    for (const char* name : kMedia) {
        const Medium& medium = find_medium(name, "test");
        std::set<std::string> all;
        for (std::size_t i = 0; i < kLineStyles; ++i) {
            const auto sample = in_style({{0, 0}, {sample_length(medium), 0}}, false, line_style(i, medium), medium);
            all.insert(felt(sample, medium));
            // A key shows each part of a style twice.
            if (!line_style(i, medium).is_whole()) {
                const auto dashes =
                    std::count_if(sample.begin(), sample.end(), [](const Stroke& s) { return length_of(s) > 0.5; });
                EXPECT_GE(dashes > 0 ? dashes : static_cast<std::ptrdiff_t>(sample.size()), 2) << name << " " << i;
            }
        }
        EXPECT_EQ(all.size(), kLineStyles) << name;
    }
}

TEST(LineStyles, MarksLieOnTheLineFromItsBeginningToItsEndAndKeepTheGap) {
    std::mt19937 random(2);
    for (const char* name : kMedia) {
        const Medium& medium = find_medium(name, "test");
        for (std::size_t i = 0; i < kLineStyles; ++i)
            for (int round = 0; round < 30; ++round) {
                const LineStyle style = line_style(i, medium);
                const double length = 7 + static_cast<double>(random() % 200), high = static_cast<double>(random() % 20);
                const auto line = wave(length, high);
                const auto strokes = in_style(line, false, style, medium);
                ASSERT_FALSE(strokes.empty());
                const double width = width_of(style.line, medium);
                for (std::size_t k = 0; k < strokes.size(); ++k) {
                    for (const Point& p : strokes[k].points) {
                        double away = INFINITY;
                        for (std::size_t s = 1; s < line.size(); ++s)
                            away = std::min(away, distance_to_segment(p, line[s - 1], line[s]));
                        ASSERT_LE(away, 1e-6);
                    }
                    if (k == 0) continue;
                    const double gap = distance(strokes[k - 1].points.back(), strokes[k].points.front()) - width;
                    EXPECT_GE(gap, medium.gap - 1e-6) << name << " " << i;
                }
                if (strokes.size() > 1 && high < length / 20) {  // elsewhere a corner may take the last one
                    EXPECT_LE(distance(strokes.front().points.front(), line.front()), 1e-6);
                    EXPECT_LE(distance(strokes.back().points.back(), line.back()), 1.0) << name << " " << i;
                }
            }
    }
}

TEST(LineStyles, AClosedLineHasAGapWhereItBegins) {
    const Medium& medium = find_medium("swell", "test");
    std::vector<Point> ring;
    for (int i = 0; i < 60; ++i) ring.push_back({20 * std::cos(i * 0.10472), 20 * std::sin(i * 0.10472)});
    for (const std::size_t i : {1u, 3u, 4u}) {
        const auto strokes = in_style(ring, true, line_style(i, medium), medium);
        ASSERT_GE(strokes.size(), 3u);
        EXPECT_GE(distance(strokes.back().points.back(), strokes.front().points.front()) - width_of(strokes[0].line, medium),
                  medium.gap - 1e-6);
    }
}

}  // namespace
}  // namespace tactics::line_styles_test
