// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/print_fonts.h"

#include "print/letters.h"

namespace tactics {

namespace {

constexpr std::size_t kMostFonts = 24;
constexpr int kCurvePieces = 8;  // of a curve

FontShape shape_of(const Letter& letter) {
    const auto point = [](const LetterCorner& corner) { return Point{corner.x / 1000.0, corner.y / 1000.0}; };
    FontShape shape{letter.advance / 1000.0, {}};
    Point at;
    for (const OutlineStep& step : letter.outline) {
        if (step.kind == OutlineStep::Kind::move) shape.rings.emplace_back();
        if (shape.rings.empty()) continue;
        const Point a = point(step.corners[0]);
        if (step.kind != OutlineStep::Kind::curve) {
            shape.rings.back().push_back(a);
            at = a;
            continue;
        }
        const Point b = point(step.corners[1]), end = point(step.corners[2]);
        for (int i = 1; i <= kCurvePieces; ++i) {
            const double t = static_cast<double>(i) / kCurvePieces, s = 1 - t;
            const double k0 = s * s * s, k1 = 3 * s * s * t, k2 = 3 * s * t * t, k3 = t * t * t;
            shape.rings.back().push_back(
                {k0 * at.x + k1 * a.x + k2 * b.x + k3 * end.x, k0 * at.y + k1 * a.y + k2 * b.y + k3 * end.y});
        }
        at = end;
    }
    return shape;
}

}  // namespace

void each_print_font(const std::vector<char32_t>& codes, const std::function<bool(FontShapes)>& goes_on) {
    std::size_t number = 0;
    each_font([&](const FontLetters& font) {
        FontShapes shapes;
        for (const auto& [code, letter] : font(codes, Hinting::none, 0))
            if (FontShape shape = shape_of(letter); !shape.rings.empty()) shapes.emplace(code, std::move(shape));
        return goes_on(std::move(shapes)) && ++number < kMostFonts;
    });
}

}  // namespace tactics
