// SPDX-License-Identifier: Apache-2.0
// An arrow that touches the thing it points to cannot be distinguished from it.
#include <algorithm>

#include "tactics/rules/arrows.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_arrow_gap(const PageGeometry& geometry, double limit) {
    Findings findings;
    const std::vector<std::uint32_t> heads = chains_with(geometry, Role::arrow);
    if (heads.empty()) return findings;
    ArrowTargets targets(geometry);
    for (const std::uint32_t c : heads) {
        const auto head = arrow_head(geometry, c);
        if (!head) continue;
        const auto target = targets.before(*head, head->tip, limit);
        if (!target || target->gap >= limit - kRounding) continue;
        const double gap = std::max(0.0, target->gap);
        findings.places.push_back({gap, head->tip, target->at,
                                   gap > 0 ? phrase("an arrow that ends {0} mm before what it points to", shown(gap))
                                           : phrase("an arrow that touches what it points to")});
    }
    findings.complete = targets.complete();
    return findings;
}

}  // namespace

extern const Rule arrow_gap_rule;
const Rule arrow_gap_rule{
    .name = "arrow-gap",
    .summary = "arrows do not touch what they point to",
    .mend = "shorten the arrow",
    .source =
        "accessiblegraphics.org: arrows have open heads, which must not touch what they point to. The distance is the general "
        "minimum gap, 1/8 in",
    .confidence = Confidence::good,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 3.2,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum distance from the tip to what it points to"},
    .check = check_arrow_gap,
};

}  // namespace tactics
