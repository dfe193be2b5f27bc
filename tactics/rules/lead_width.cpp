// SPDX-License-Identifier: Apache-2.0
// A lead line is the least line of a page: it is not a part of the drawing.
#include <limits>

#include "tactics/rules/arrows.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_lead_width(const PageGeometry& geometry, double limit) {
    Findings findings;
    double thinnest = std::numeric_limits<double>::infinity();
    for (const Chain& chain : geometry.chains)
        if (!chain.ring && geometry.role_of(chain) != Role::lead) thinnest = std::min(thinnest, 2 * chain.half_width);
    for (const std::uint32_t c : chains_with(geometry, Role::lead)) {
        const Chain& chain = geometry.chains[c];
        const double more = 2 * chain.half_width - thinnest;
        if (more <= limit + kRounding) continue;
        findings.places.push_back({more,
                                   geometry.point_at({c, chain.length / 2}),
                                   {},
                                   phrase("a lead line {0} mm wide, where a line of the drawing has {1} mm",
                                          shown(2 * chain.half_width), shown(thinnest))});
    }
    return findings;
}

}  // namespace

extern const Rule lead_width_rule;
const Rule lead_width_rule{
    .name = "lead-width",
    .summary = "lead lines are no wider than the thinnest line of the drawing",
    .mend = "draw the lead line thinner",
    .source =
        "a rule file after BANA 3.4.3.5: the least line of the page, 3/4 to 1 1/2 in (2 to 3.75 cm) long, without arrow head; "
        "known at second hand",
    .confidence = Confidence::medium,
    .limit = {.name = "most",
              .type = Option::Type::length,
              .fallback = 0,
              .min = 0,
              .max = 10,
              .unit = "mm",
              .summary = "how much wider than the thinnest line a lead line may be"},
    .check = check_lead_width,
};

}  // namespace tactics
