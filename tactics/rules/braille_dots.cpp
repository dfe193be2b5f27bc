// SPDX-License-Identifier: Apache-2.0
// Dots of a braille cell stand where a reader's finger expects them.
#include "tactics/rules/braille_standard.h"

namespace tactics {

namespace {

Findings check_braille_dots(const PageGeometry& geometry, double limit) {
    const double pitch = geometry.page.cell.dot_pitch, off = off_standard(pitch, &CellSize::dot_pitch);
    const auto at = first_braille(geometry);
    if (!at || off <= limit + kRounding) return {};
    return {{{off, *at, {}, phrase("braille whose dots stand {0} mm apart, {1} mm off the standard", shown(pitch), shown(off))}}};
}

}  // namespace

extern const Rule braille_dots_rule;
const Rule braille_dots_rule{
    .name = "braille-dots",
    .summary = "dots of a braille cell 2.34 mm (NLS) or 2.5 mm (Marburg Medium) apart",
    .mend = "set the braille in its true size; it cannot be scaled",
    .source = "NLS Specification 800: 2.34 mm; Marburg Medium (SONS P4008055): 2.5 mm within 4 %",
    .confidence = Confidence::good,
    .hard = true,
    .limit = {.name = "most",
              .type = Option::Type::length,
              .fallback = 0.1,
              .min = 0,
              .max = 5,
              .unit = "mm",
              .summary = "maximum deviation of dots from the nearest standard"},
    .check = check_braille_dots,
};

}  // namespace tactics
