// SPDX-License-Identifier: Apache-2.0
// So much black that swell paper is spoilt.
#include "tactics/rules/coverage.h"

namespace tactics {

extern const Rule ink_limit_rule;
const Rule ink_limit_rule{
    .name = "ink-limit",
    .summary = "never so much black that swell paper is spoilt",
    .mend = "draw outlines instead of black areas",
    .source = "one tool's own number (fabric-accessible-graphics: refuses at 45 %)",
    .confidence = Confidence::uncertain,
    .hard = true,
    .limit = {.name = "most",
              .type = Option::Type::number,
              .fallback = 45,
              .min = 0,
              .max = 100,
              .unit = "percent",
              .summary = "maximum share of the page that may be black"},
    .limit_for = [](const Medium& medium) { return only_swell(medium, 45); },
    .check = ink_beyond,
};

}  // namespace tactics
