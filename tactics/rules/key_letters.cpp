// SPDX-License-Identifier: Apache-2.0
// A key entry is marked in the drawing by two letters.
#include <cmath>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_key_letters(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const PageName& name : geometry.page.names) {
        if (name.key.empty()) continue;
        const double off = std::abs(static_cast<double>(name.key.size()) - 2);
        if (off <= limit) continue;
        findings.places.push_back({off,
                                   {name.place.left, name.place.top},
                                   {},
                                   phrase("\"{0}\" for \"{1}\", which is not two letters", name.key, name.text)});
    }
    return findings;
}

}  // namespace

extern const Rule key_letters_rule;
const Rule key_letters_rule{
    .name = "key-letters",
    .summary = "a key entry is marked in the drawing by two letters",
    .mend = "take two letters for each thing that the key explains",
    .source = "NBA Tactile Graphics Committee: two letters; single letters are not recommended",
    .confidence = Confidence::good,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 0,
              .min = 0,
              .max = 100,
              .summary = "maximum number of letters missing or in excess"},
    .check = check_key_letters,
};

}  // namespace tactics
