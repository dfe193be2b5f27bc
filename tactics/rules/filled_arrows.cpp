// SPDX-License-Identifier: Apache-2.0
// A filled head is felt as a blob at the end of a line.
#include "tactics/rules/arrows.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_filled_arrows(const PageGeometry& geometry, double limit) {
    double filled = 0;
    Point first;
    for (const std::uint32_t c : chains_with(geometry, Role::arrow)) {
        const Chain& chain = geometry.chains[c];
        if (!chain.ring && !chain.closed) continue;
        if (filled++ == 0) first = geometry.point_at({c, 0});
    }
    if (filled <= limit) return {};
    return {{{filled,
              first,
              {},
              phrases(static_cast<std::size_t>(filled), "{0} arrow head that is filled or closed",
                      "{0} arrow heads that are filled or closed, the first here")}}};
}

}  // namespace

extern const Rule filled_arrows_rule;
const Rule filled_arrows_rule{
    .name = "filled-arrows",
    .summary = "arrow heads are open",
    .mend = "draw the head as two lines that meet at the tip",
    .source = "accessiblegraphics.org: arrows have open heads and do not touch what they point to",
    .confidence = Confidence::good,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 0,
              .min = 0,
              .max = 1000,
              .summary = "maximum number of filled or closed arrow heads"},
    .check = check_filled_arrows,
};

}  // namespace tactics
