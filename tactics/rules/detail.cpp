// SPDX-License-Identifier: Apache-2.0
// What is smaller than a fingertip can tell.
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_detail(const PageGeometry& geometry, double limit) {
    Findings findings;
    const auto look = [&](const std::vector<std::uint32_t>& chains, bool is_hole) {
        const double extent = geometry.extent_of(chains, limit);
        if (extent < limit - kRounding)
            findings.places.push_back(
                {extent,
                 geometry.point_at({chains[0], 0}),
                 {},
                 is_hole ? phrase("a hole {0} mm across", shown(extent)) : phrase("a speck {0} mm across", shown(extent))});
    };
    for (const auto& figure : geometry.figures) {
        bool only_holes = true;
        for (const std::uint32_t c : figure)
            only_holes = only_holes && geometry.chains[c].ring && geometry.is_hole(geometry.chains[c]);
        look(figure, only_holes);
    }
    return findings;
}

}  // namespace

extern const Rule detail_rule;
const Rule detail_rule{
    .name = "detail",
    .summary = "no specks or holes too small for a fingertip",
    .mend = "leave it out or draw it larger",
    .source = "R. E. Ladner and others: a fingertip resolves about 25 dots per inch, 1 mm",
    .confidence = Confidence::medium,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 1,
              .min = 0.05,
              .max = 20,
              .unit = "mm",
              .summary = "minimum size of anything, measured along its longest extent"},
    .check = check_detail,
};

}  // namespace tactics
