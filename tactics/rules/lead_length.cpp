// SPDX-License-Identifier: Apache-2.0
// A hand that follows a long lead line takes it for a part of the drawing.
#include "tactics/rules/arrows.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_lead_length(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const std::uint32_t c : chains_with(geometry, Role::lead)) {
        const Chain& chain = geometry.chains[c];
        if (chain.length <= limit + kRounding) continue;
        findings.places.push_back(
            {chain.length, geometry.point_at({c, chain.length / 2}), {}, phrase("a lead line {0} mm long", shown(chain.length))});
    }
    return findings;
}

}  // namespace

extern const Rule lead_length_rule;
const Rule lead_length_rule{
    .name = "lead-length",
    .summary = "lead lines are not too long",
    .mend = "move the words nearer, or put two letters there and the words in a key",
    .source =
        "a rule file after BANA 3.4.3.5: the least line of the page, 3/4 to 1 1/2 in (2 to 3.75 cm) long, without arrow head; "
        "known at second hand",
    .confidence = Confidence::medium,
    .limit = {.name = "most",
              .type = Option::Type::length,
              .fallback = 38.1,
              .min = 1,
              .max = 1000,
              .unit = "mm",
              .summary = "maximum length of a lead line"},
    .check = check_lead_length,
};

}  // namespace tactics
