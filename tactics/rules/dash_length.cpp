// SPDX-License-Identifier: Apache-2.0
// The dashes of a line must be long enough to be felt as parts of a line, not as dots.
#include "tactics/rules/dashes.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_dash_length(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const DashedLine& line : dashed_lines(geometry)) {
        // The last one is what is left of the line, so it may be short.
        std::size_t shortest = line.front();
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            if (geometry.chains[line[i]].length < geometry.chains[shortest].length) shortest = line[i];
        const Chain& chain = geometry.chains[shortest];
        const double length = felt_length(chain);
        if (line.size() > 1 && length < limit - kRounding)
            findings.places.push_back({length,
                                       geometry.point_at({shortest, chain.length / 2}),
                                       {},
                                       phrase("a line with a dash {0} mm long", shown(length))});
    }
    return findings;
}

}  // namespace

extern const Rule dash_length_rule;
const Rule dash_length_rule{
    .name = "dash-length",
    .summary = "the dashes of dashed lines are long enough",
    .mend = "draw longer dashes",
    .source =
        "a rule file after BANA 3.4.3.3: dashes 1/4 to 3/8 in (6 to 10 mm) long, gaps about half a dash; known at second hand",
    .confidence = Confidence::medium,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 6,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum length of a dash, ends included"},
    .check = check_dash_length,
};

}  // namespace tactics
