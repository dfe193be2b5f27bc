// SPDX-License-Identifier: Apache-2.0
// A point symbol must be large enough for its form to be felt.
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"
#include "tactics/rules/symbols.h"

namespace tactics {

namespace {

Findings check_symbol_size(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const Symbol& symbol : symbols_of(geometry))
        if (symbol.size < limit - kRounding)
            findings.places.push_back(
                {symbol.size, symbol.middle, {}, phrase("a point symbol {0} mm across", shown(symbol.size))});
    return findings;
}

}  // namespace

extern const Rule symbol_size_rule;
const Rule symbol_size_rule{
    .name = "symbol-size",
    .summary = "point symbols large enough to be told apart",
    .mend = "draw it larger",
    .source = "one project's reading of the Guidelines and Standards for Tactile Graphics 2022",
    .confidence = Confidence::uncertain,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 5,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum size of a point symbol, measured along its longest extent"},
    .check = check_symbol_size,
};

}  // namespace tactics
