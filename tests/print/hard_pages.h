// SPDX-License-Identifier: Apache-2.0
// Pages that are hard to print right, for all formats' tests.
#pragma once

#include <cmath>
#include <numbers>

#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics::rendered {

inline Sheet sheet_of(const char* paper, const std::string& title = "") {
    Sheet sheet;
    sheet.paper = find_paper(paper, "test");
    sheet.medium = &find_medium("swell", "test");
    sheet.title = title;
    return sheet;
}

/// A circle's worth of points.
inline std::vector<Point> ring(Point centre, double radius, int points) {
    std::vector<Point> out;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        out.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return out;
}

/// 5,000 points in one stroke, a ring with a hole, a star that crosses itself, a stroke of no length, sharp corners.
inline Drawing hard_drawing() {
    Drawing drawing;
    drawing.width = 180;
    drawing.height = 120;
    Stroke spiral;
    for (int i = 0; i < 5000; ++i) {
        const double angle = i * 0.011, radius = 1 + i * 0.0096;
        spiral.points.push_back({60 + radius * std::cos(angle), 60 + radius * std::sin(angle)});
    }
    drawing.strokes.push_back(spiral);
    drawing.areas.push_back({{ring({140, 25}, 20, 90), ring({140, 25}, 10, 45)}});
    Area star;
    star.rings.emplace_back();
    for (int i = 0; i < 5; ++i) star.rings[0].push_back(ring({140, 75}, 22, 5)[static_cast<std::size_t>(i * 2 % 5)]);
    drawing.areas.push_back(star);
    drawing.strokes.push_back({{{120, 110}, {120, 110}}, false, LineClass::thick, 0});
    drawing.strokes.push_back({{{130, 105}, {150, 106}, {130, 107}, {160, 115}}, false, LineClass::thin, 0, Role::lead});
    drawing.strokes.push_back({{{165, 60}, {178, 60}, {172, 110}}, true, LineClass::thick, 0});
    return drawing;
}

/// A page of one bit a pixel.
inline Drawing picture_drawing(int width, int height) {
    Drawing drawing;
    drawing.width = width / 10.0;
    drawing.height = height / 10.0;
    Image image = make_image(width, height, 1, 0.1, 255);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double wave = std::sin(x * 0.05) * std::cos(y * 0.07) + std::sin((x + 2 * y) * 0.02);
            if (std::abs(wave) < 0.15 || x == y) image.row(y)[x] = 0;
        }
    drawing.picture = image;
    return drawing;
}

}  // namespace tactics::rendered
