// SPDX-License-Identifier: Apache-2.0
// Dashes that are too long are felt as lines of their own.
#include "tactics/rules/dashes.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_long_dashes(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const DashedLine& line : dashed_lines(geometry)) {
        std::size_t longest = line.front();
        for (const std::size_t dash : line)
            if (geometry.chains[dash].length > geometry.chains[longest].length) longest = dash;
        const Chain& chain = geometry.chains[longest];
        const double length = felt_length(chain);
        if (length > limit + kRounding)
            findings.places.push_back({length,
                                       geometry.point_at({longest, chain.length / 2}),
                                       {},
                                       phrase("a line with a dash {0} mm long", shown(length))});
    }
    return findings;
}

}  // namespace

extern const Rule long_dashes_rule;
const Rule long_dashes_rule{
    .name = "long-dashes",
    .summary = "dashes short enough that each is not felt as a line of its own",
    .mend = "draw shorter dashes",
    .source =
        "a rule file after BANA 3.4.3.3: dashes 1/4 to 3/8 in (6 to 10 mm) long, gaps about half a dash; known at second hand",
    .confidence = Confidence::medium,
    .limit = {.name = "most",
              .type = Option::Type::length,
              .fallback = 10,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "maximum length of a dash, ends included"},
    .check = check_long_dashes,
};

}  // namespace tactics
