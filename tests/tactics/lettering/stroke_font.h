// SPDX-License-Identifier: Apache-2.0
// A font of straight strokes, and print in it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "tactics/lettering/letter_form.h"
#include "tactics/lettering/lines.h"

namespace tactics::stroke_font {

inline std::vector<Point> box(double left, double bottom, double right, double top) {
    return {{left, bottom}, {left, top}, {right, top}, {right, bottom}};
}

inline FontShape ring(double width, double height, double thick) {
    return {width + 0.1,
            {box(0.05, 0, 0.05 + width, thick), box(0.05, height - thick, 0.05 + width, height),
             box(0.05, 0, 0.05 + thick, height), box(0.05 + width - thick, 0, 0.05 + width, height)}};
}

// Letters of straight strokes so thick, small ones so high: L, T, H, O, o, n, i, 0 and 1, and a 7 of so many times their height.
inline FontShapes strokes(double thick, double low, double seven = 1) {
    return {{U'L', {0.6, {box(0.05, 0, 0.05 + thick, 0.7), box(0.05, 0, 0.5, thick)}}},
            {U'T', {0.6, {box(0.05, 0.7 - thick, 0.55, 0.7), box(0.3 - thick / 2, 0, 0.3 + thick / 2, 0.7)}}},
            {U'H', {0.7, {box(0.05, 0, 0.05 + thick, 0.7), box(0.6 - thick, 0, 0.6, 0.7), box(0.05, 0.33, 0.6, 0.33 + thick)}}},
            {U'O', ring(0.6, 0.7, thick)},
            {U'o', ring(0.4, low, thick)},
            {U'0', ring(0.4, 0.7, thick)},
            {U'n', {0.5, {box(0.05, 0, 0.05 + thick, low), box(0.45 - thick, 0, 0.45, low), box(0.05, low - thick, 0.45, low)}}},
            {U'i', {0.25, {box(0.1, 0, 0.1 + thick, low), box(0.1, 0.6, 0.1 + thick, 0.7)}}},
            {U'1', {0.5, {box(0.22, 0, 0.22 + thick, 0.7), box(0.08, 0, 0.4, thick), box(0.1, 0.55, 0.25, 0.6)}}},
            {U'7',
             {0.5 * seven,
              {box(0.05 * seven, 0.6 * seven, 0.42 * seven, 0.7 * seven), box(0.3 * seven, 0, 0.42 * seven, 0.7 * seven)}}}};
}

// As a program does that fades edges: each pixel by parts of it, whose middles are within a box.
inline Image written(const FontShapes& font, std::u32string_view text, double em, double closer = 0) {
    Image image = make_image(320, 60, 1, 0, 255);
    constexpr int kParts = 4;
    double left = 20.3;
    for (const char32_t code : text) {
        if (code == U' ') {
            left += 0.35 * em;
            continue;
        }
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                int inside = 0;
                for (int part = 0; part < kParts * kParts; ++part) {
                    const double px = (x + (part % kParts + 0.5) / kParts - left) / em,
                                 py = (40.6 - y - (part / kParts + 0.5) / kParts) / em;
                    const auto& rings = font.at(code).rings;
                    inside += std::any_of(rings.begin(), rings.end(), [&](const auto& one) {
                        return px > one[0].x && px < one[2].x && py > one[0].y && py < one[2].y;
                    });
                }
                std::uint8_t& pixel = image.row(y)[x];
                pixel = static_cast<std::uint8_t>(std::min<int>(pixel, 255 - 255 * inside / (kParts * kParts)));
            }
        left += (font.at(code).advance - closer) * em;
    }
    return image;
}

inline LetteringLine line_in(const Image& image) {
    const auto lines = find_lettering(image);
    EXPECT_EQ(lines.size(), 1u);
    return lines.empty() ? LetteringLine() : lines[0];
}

}  // namespace tactics::stroke_font
