// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/print_fonts.h"

#include "print/letters.h"

namespace tactics {

namespace {

constexpr std::size_t kMostFonts = 44;
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

FontShapes shapes_of(const FontLetters::Of& font, const std::vector<char32_t>& codes, Hinting hinting, double em) {
    FontShapes shapes;
    for (const auto& [code, letter] : font(codes, hinting, em))
        if (FontShape shape = shape_of(letter); !shape.rings.empty()) shapes.emplace(code, std::move(shape));
    return shapes;
}

}  // namespace

void each_print_font(const std::vector<char32_t>& codes, const std::function<bool(PrintFont)>& goes_on) {
    using Codes = std::vector<char32_t>;
    std::size_t number = 0;
    each_font([&](const FontLetters& font) {
        const auto plain = [font](const Codes& wanted) { return shapes_of(font.plain, wanted, Hinting::none, 0); };
        // Plotting programs bend letters upwards and downwards, and leave their widths.
        const auto bent = [font](const Codes& wanted, double em) { return shapes_of(font.plain, wanted, Hinting::light, em); };
        PrintFont print{plain(codes), plain, bent, {}};
        if (font.formula)
            print.formula = [font](const Codes& wanted) { return shapes_of(font.formula, wanted, Hinting::none, 0); };
        return goes_on(std::move(print)) && ++number < kMostFonts;
    });
}

}  // namespace tactics
