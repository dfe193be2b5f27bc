// SPDX-License-Identifier: Apache-2.0
// An embosser has dots at fixed places: two lines with no empty row of dots between them become one.
#include "tactics/rules/narrow.h"

namespace tactics {

namespace {

Findings check_merging_dots(const PageGeometry& geometry, double limit) {
    Findings findings = narrow_places(geometry, limit, Apart::middles);
    for (Finding& finding : findings.places)
        finding.message =
            phrase("the middles of {0} are {1} mm apart and their dots merge", finding.message, shown(finding.measured));
    return findings;
}

}  // namespace

extern const Rule merging_dots_rule;
const Rule merging_dots_rule{
    .name = "merging-dots",
    .summary = "on an embosser an empty row of dots between two lines",
    .mend = "move them apart or leave one out",
    .source =
        "Thinkable, tactile usability: a line and a gap need at least one dot, more gap is better; dots stand 2.5 mm apart "
        "(Marburg Medium, SONS P4008055), so two rows are 5 mm",
    .confidence = Confidence::good,
    .hard = true,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = kTwoRows,
              .min = 0.1,
              .max = 50,
              .unit = "mm",
              .summary = "minimum distance from the middle of one to the middle of the other"},
    .limit_for = [](const Medium& medium) { return has_fixed_dots(medium) ? std::optional(kTwoRows) : std::nullopt; },
    .check = check_merging_dots,
};

}  // namespace tactics
