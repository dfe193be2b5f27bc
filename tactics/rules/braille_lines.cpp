// SPDX-License-Identifier: Apache-2.0
// Lines of braille stand far enough apart that one finger does not read two.
#include "tactics/rules/braille_standard.h"

namespace tactics {

namespace {

constexpr std::size_t kBrailleLinesMostPairs = 10'000'000;

Findings check_braille_lines(const PageGeometry& geometry, double limit) {
    if (geometry.braille.size() < 2) return {};
    // From dot 1 to dot 1; the boxes begin half a dot above. A line nearer than the standard less the limit is wrong, one that is
    // further away is only another text.
    const double least = kLeastLinePitch - limit - kRounding;
    std::vector<Box> boxes = geometry.braille;
    for (Box& box : boxes) {
        box.top -= least / 2;
        box.bottom += least / 2;
    }
    Findings findings;
    const Grid grid(std::move(boxes), geometry.page.width, geometry.page.height);
    findings.complete = grid.pairs(kBrailleLinesMostPairs, [&](std::size_t i, std::size_t j) {
        const Box &a = geometry.braille[i], &b = geometry.braille[j];
        const double pitch = std::abs(a.top - b.top);
        if (a.left > b.right || b.left > a.right || pitch >= least) return true;
        const Box& lower = a.top > b.top ? a : b;
        findings.places.push_back({kLeastLinePitch - pitch,
                                   {lower.left, lower.top},
                                   {},
                                   phrase("two lines of braille {0} mm apart, {1} mm less than the standard", shown(pitch),
                                          shown(kLeastLinePitch - pitch))});
        return findings.places.size() <= kMostPlaces;
    });
    return findings;
}

}  // namespace

extern const Rule braille_lines_rule;
const Rule braille_lines_rule{
    .name = "braille-lines",
    .summary = "braille lines at least 10 mm apart",
    .mend = "move the lines of braille apart",
    .source = "NLS Specification 800: 10.0 mm; Marburg Medium (SONS P4008055): 10.1 mm within 9 %",
    .confidence = Confidence::good,
    .hard = true,
    .limit = {.name = "most",
              .type = Option::Type::length,
              .fallback = 0.9,
              .min = 0,
              .max = 10,
              .unit = "mm",
              .summary = "maximum by which lines may be closer than 10 mm"},
    .check = check_braille_lines,
};

}  // namespace tactics
