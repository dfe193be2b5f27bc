// SPDX-License-Identifier: Apache-2.0
// Letters of the upper dots alone cannot be placed in their cell by a finger.
#include <algorithm>

#include "tactics/layout/key.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

// Dot 3 or 6.
bool is_low(char letter) { return letter >= 'a' && letter <= 'z' && (letter_cell(letter) & 0b100100) != 0; }

Findings check_key_dots(const PageGeometry& geometry, double limit) {
    double without = 0;
    Point first;
    std::string key;
    for (const PageName& name : geometry.page.names) {
        if (name.key.empty() || std::any_of(name.key.begin(), name.key.end(), is_low)) continue;
        if (without++ > 0) continue;
        first = {name.place.left, name.place.top};
        key = name.key;
    }
    if (without <= limit) return {};
    return {{{without,
              first,
              {},
              phrases(static_cast<std::size_t>(without), "{0} entry of a key without dot 3 or 6, such as {1} here",
                      "{0} entries of a key without dot 3 or 6, such as {1} here", key)}}};
}

}  // namespace

extern const Rule key_dots_rule;
const Rule key_dots_rule{
    .name = "key-dots",
    .summary = "every two-letter key entry has a dot 3 or 6",
    .mend = "take letters with a low dot, such as k to z",
    .source =
        "NBA Tactile Graphics Committee: two letters, of which at least one has a dot 3 or 6; single letters are not "
        "recommended",
    .confidence = Confidence::good,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 0,
              .min = 0,
              .max = 1000,
              .summary = "maximum number of entries without a low dot"},
    .check = check_key_dots,
};

}  // namespace tactics
