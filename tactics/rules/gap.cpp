// SPDX-License-Identifier: Apache-2.0
// A clear gap between two things, or a finger takes them for one.
#include "tactics/rules/narrow.h"

namespace tactics {

namespace {

Findings check_gap(const PageGeometry& geometry, double limit) {
    Findings findings = narrow_places(geometry, limit, Apart::edges);
    for (Finding& finding : findings.places)
        finding.message = phrase("a gap of {0} mm between {1}", shown(finding.measured), finding.message);
    return findings;
}

}  // namespace

extern const Rule gap_rule;
const Rule gap_rule{
    .name = "gap",
    .summary = "a clear gap between any two things that do not touch",
    .mend = "move them apart or join them",
    .source =
        "L. Hasty, Designing Tactile Graphics: 1/8 in is the absolute minimum between any two elements, 1/4 in may be needed on "
        "capsule paper; lines closer than 6 mm are hard to tell (APH guide, Bristol). For thermoform this project asks for more",
    .confidence = Confidence::good,
    .hard = true,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 3.2,
              .min = 0.1,
              .max = 50,
              .unit = "mm",
              .summary = "minimum distance from edge to edge"},
    .limit_for = [](const Medium& medium) { return std::optional(medium.gap); },
    .check = check_gap,
};

}  // namespace tactics
