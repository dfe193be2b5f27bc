// SPDX-License-Identifier: Apache-2.0
// Swell paper with much black on it heats unevenly.
#include "tactics/rules/coverage.h"

namespace tactics {

extern const Rule ink_rule;
const Rule ink_rule{
    .name = "ink",
    .summary = "not too much black on swell paper",
    .mend = "draw outlines instead of black areas",
    .source = "one tool's own number (fabric-accessible-graphics: aims at 30 %, warns at 40 %)",
    .confidence = Confidence::uncertain,
    .limit = {.name = "most",
              .type = Option::Type::number,
              .fallback = 40,
              .min = 0,
              .max = 100,
              .unit = "percent",
              .summary = "maximum share of the page that may be black"},
    .limit_for = [](const Medium& medium) { return only_swell(medium, 40); },
    .check = ink_beyond,
};

}  // namespace tactics
