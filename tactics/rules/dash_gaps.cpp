// SPDX-License-Identifier: Apache-2.0
// The gaps of a dashed line: a finger is to find the next dash without searching, and to feel that there is a gap.
#include <cmath>

#include "tactics/rules/dashes.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

constexpr double kShare = 0.5;  // of its dash

Findings check_dash_gaps(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const DashedLine& line : dashed_lines(geometry)) {
        double most = limit + kRounding;
        Finding worst;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Chain& chain = geometry.chains[line[i]];
            const double gap = dash_gap(geometry, line[i], line[i + 1]), off = std::abs(gap / felt_length(chain) - kShare);
            if (off <= most) continue;
            most = off;
            worst = {off, geometry.point_at({line[i], chain.length}), geometry.point_at({line[i + 1], 0}),
                     phrase("a line with a gap of {0} mm behind a dash of {1} mm", shown(gap), shown(felt_length(chain)))};
        }
        if (!worst.message.empty()) findings.places.push_back(worst);
    }
    return findings;
}

}  // namespace

extern const Rule dash_gaps_rule;
const Rule dash_gaps_rule{
    .name = "dash-gaps",
    .summary = "gaps in dashed lines are about half as long as the dashes",
    .mend = "make each gap half as long as its dash",
    .source =
        "a rule file after BANA 3.4.3.3: gaps about half a dash, known at second hand. The tolerance is this project's own "
        "choice",
    .confidence = Confidence::medium,
    .limit = {.name = "most",
              .type = Option::Type::number,
              .fallback = 0.25,
              .min = 0.01,
              .max = 10,
              .summary = "how much a gap may differ from half its dash, as a share of the dash"},
    .check = check_dash_gaps,
};

}  // namespace tactics
