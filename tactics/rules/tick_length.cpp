// SPDX-License-Identifier: Apache-2.0
// A tick mark must be long enough to be found along its axis.
#include "tactics/rules/arrows.h"
#include "tactics/rules/dashes.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_tick_length(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const std::uint32_t c : chains_with(geometry, Role::tick)) {
        const Chain& chain = geometry.chains[c];
        if (felt_length(chain) >= limit - kRounding) continue;
        findings.places.push_back({felt_length(chain),
                                   geometry.point_at({c, chain.length / 2}),
                                   {},
                                   phrase("a tick mark {0} mm long", shown(felt_length(chain)))});
    }
    return findings;
}

}  // namespace

extern const Rule tick_length_rule;
const Rule tick_length_rule{
    .name = "tick-length",
    .summary = "tick marks long enough to be found",
    .mend = "draw them longer, on both sides of the axis",
    .source =
        "NBA Tactile Graphics Committee on BANA 3.4.3.4 and 6.6.2.2: tick marks are 1/2 in long in total, 1/4 in on each side "
        "of the axis",
    .confidence = Confidence::good,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 12.7,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum length of a tick mark, ends included"},
    .check = check_tick_length,
};

}  // namespace tactics
