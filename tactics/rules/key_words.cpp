// SPDX-License-Identifier: Apache-2.0
// The hand finds the words of a key in one column.
#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

#include "tactics/layout/key.h"
#include "tactics/layout/named_lines.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

// The beginning of the words after the letters: the first cell after a blank.
std::size_t words_in(const BrailleLine& line) {
    const auto blank = std::find(line.cells.begin(), line.cells.end(), std::uint8_t{0});
    const auto word = std::find_if(blank, line.cells.end(), [](std::uint8_t cell) { return cell != 0; });
    return static_cast<std::size_t>(word - line.cells.begin());
}

Findings check_key_words(const PageGeometry& geometry, double limit) {
    Findings findings;
    const Page& page = geometry.page;
    if (!page.is_key) return findings;
    const std::vector<const PageName*> names = names_of_lines(page);
    std::unordered_set<const PageName*> begun;  // further lines of an entry go on with its words
    for (std::size_t i = 0; i < names.size(); ++i) {
        const PageName* name = names[i];
        if (name == nullptr || name->key.empty() || !begun.insert(name).second) continue;
        const BrailleLine& line = page.braille[i];
        const std::size_t words = words_in(line);
        const double off = std::abs(static_cast<double>(words) - static_cast<double>(kWordsFrom));
        if (words == line.cells.size() || off <= limit) continue;
        findings.places.push_back({off,
                                   line.first_dot,
                                   {},
                                   phrase("the words for {0} begin in cell {1}, not in cell {2}", name->key,
                                          std::to_string(words + 1), std::to_string(kWordsFrom + 1))});
    }
    return findings;
}

}  // namespace

extern const Rule key_words_rule;
const Rule key_words_rule{
    .name = "key-words",
    .summary = "the words of a key begin in cell 6",
    .mend = "leave so many cells blank that they begin in cell 6",
    .source = "BANA, Guidelines and Standards for Tactile Graphics, on keys: the explanation begins in cell 6",
    .confidence = Confidence::good,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 0,
              .min = 0,
              .max = 40,
              .summary = "maximum number of cells by which the words of an entry begin too early or too late"},
    .check = check_key_words,
};

}  // namespace tactics
