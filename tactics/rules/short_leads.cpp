// SPDX-License-Identifier: Apache-2.0
// A short lead line may be mistaken for a part of the thing it leads to.
#include "tactics/rules/arrows.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_short_leads(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const std::uint32_t c : chains_with(geometry, Role::lead)) {
        const Chain& chain = geometry.chains[c];
        if (chain.length >= limit - kRounding) continue;
        findings.places.push_back(
            {chain.length, geometry.point_at({c, chain.length / 2}), {}, phrase("a lead line {0} mm long", shown(chain.length))});
    }
    return findings;
}

}  // namespace

extern const Rule short_leads_rule;
const Rule short_leads_rule{
    .name = "short-leads",
    .summary = "lead lines long enough to be followed as lines",
    .mend = "put the words right beside the thing, or farther off",
    .source =
        "a rule file after BANA 3.4.3.5: the least line of the page, 3/4 to 1 1/2 in (2 to 3.75 cm) long, without arrow head; "
        "known at second hand. We know no source that says a shorter one is worse than none; names that TACTICS places itself "
        "may have shorter lead lines",
    .confidence = Confidence::medium,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 19,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum length of a lead line"},
    .check = check_short_leads,
};

}  // namespace tactics
