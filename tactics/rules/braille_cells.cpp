// SPDX-License-Identifier: Apache-2.0
// Braille cells stand as far apart as a reader's finger expects.
#include "tactics/rules/braille_standard.h"

namespace tactics {

namespace {

Findings check_braille_cells(const PageGeometry& geometry, double limit) {
    const double pitch = geometry.page.cell.cell_pitch, off = off_standard(pitch, &CellSize::cell_pitch);
    const auto at = first_braille(geometry);
    if (!at || off <= limit + kRounding) return {};
    return {
        {{off, *at, {}, phrase("braille whose cells stand {0} mm apart, {1} mm off the standard", shown(pitch), shown(off))}}};
}

}  // namespace

extern const Rule braille_cells_rule;
const Rule braille_cells_rule{
    .name = "braille-cells",
    .summary = "braille cells 6.0 mm (Marburg Medium) or 6.2 mm (NLS) apart, or as another standard has them",
    .mend = "set the braille in its true size; it cannot be scaled",
    .source =
        "NLS Specification 800: 6.2 mm; Marburg Medium (SONS P4008055): 6.0 mm within 10 %; ABA, ADA 703.3: tactics list cells",
    .confidence = Confidence::good,
    .hard = true,
    .limit = {.name = "most",
              .type = Option::Type::length,
              .fallback = 0.6,
              .min = 0,
              .max = 10,
              .unit = "mm",
              .summary = "maximum deviation of cells from the nearest standard"},
    .check = check_braille_cells,
};

}  // namespace tactics
