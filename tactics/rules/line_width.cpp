// SPDX-License-Identifier: Apache-2.0
// A line that is too thin is not raised, or not felt.
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_line_width(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const Chain& chain : geometry.chains) {
        if (chain.ring || chain.half_width * 2 >= limit - kRounding) continue;
        const Point middle = geometry.point_at({static_cast<std::size_t>(&chain - geometry.chains.data()), chain.length / 2});
        findings.places.push_back({chain.half_width * 2, middle, {}, phrase("a line {0} mm wide", shown(chain.half_width * 2))});
    }
    return findings;
}

}  // namespace

extern const Rule line_width_rule;
const Rule line_width_rule{
    .name = "line-width",
    .summary = "lines wide enough to be raised and felt",
    .mend = "draw it wider",
    .source =
        "one tool draws detail 0.7 mm wide (fabric-accessible-graphics), and 1 mm markers work on swell paper "
        "(tactilelibrary.com); an embosser's line is one dot; the number for thermoform is this project's own",
    .confidence = Confidence::uncertain,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 0.7,
              .min = 0.05,
              .max = 20,
              .unit = "mm",
              .summary = "minimum width of a line"},
    .limit_for = [](const Medium& medium) { return std::optional(medium.thin_line); },
    .check = check_line_width,
};

}  // namespace tactics
