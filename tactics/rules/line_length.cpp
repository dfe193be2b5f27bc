// SPDX-License-Identifier: Apache-2.0
// A line on its own must be long enough to be felt as a line.
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_line_length(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const auto& figure : geometry.figures) {
        if (figure.size() != 1) continue;  // a part of something larger
        const Chain& chain = geometry.chains[figure[0]];
        const double width = chain.half_width * 2;
        // A mark no longer than wide is a dot. Round ends feel like a part of the line. Lines with another role have their own
        // rules.
        if (geometry.role_of(chain) != Role::line) continue;
        if (chain.ring || chain.closed || chain.length <= width || chain.length + width >= limit - kRounding) continue;
        findings.places.push_back({chain.length + width,
                                   geometry.point_at({figure[0], chain.length / 2}),
                                   {},
                                   phrase("a line {0} mm long", shown(chain.length + width))});
    }
    return findings;
}

}  // namespace

extern const Rule line_length_rule;
const Rule line_length_rule{
    .name = "line-length",
    .summary = "lines that touch nothing are long enough to be followed",
    .mend = "draw it longer, join it to another line or leave it out",
    .source = "a rule file after BANA 3.4.3.2: a primary line is at least 1/2 in long; known at second hand",
    .confidence = Confidence::medium,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 12.7,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum length of a line, ends included"},
    .check = check_line_length,
};

}  // namespace tactics
