// The hand finds the words of a key in one column.
#include <algorithm>
#include <cmath>

#include "tactics/key.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check(const PageGeometry& geometry, double limit) {
    Findings findings;
    const Page& page = geometry.page;
    for (const PageName& name : page.names) {
        if (name.key.empty() || !std::all_of(name.key.begin(), name.key.end(), [](char c) { return c >= 'a' && c <= 'z'; })) continue;
        for (const BrailleLine& line : page.braille) {
            const std::size_t letters = name.key.size();
            if (line.cells.size() <= letters || line.cells[letters] != 0) continue;
            bool same = true;
            for (std::size_t i = 0; i < letters; ++i) same = same && line.cells[i] == letter_cell(name.key[i]);
            std::size_t words = letters;
            while (words < line.cells.size() && line.cells[words] == 0) ++words;
            if (!same || words == line.cells.size()) continue;
            const double off = std::abs(static_cast<double>(words) - static_cast<double>(kWordsFrom));
            if (off <= limit) continue;
            findings.places.push_back({off, line.first_dot, {},
                                       "the words for " + name.key + " begin in cell " + std::to_string(words + 1) + ", not in cell " +
                                           std::to_string(kWordsFrom + 1)});
        }
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
    .hard = false,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 0,
              .min = 0,
              .max = 40,
              .unit = "",
              .summary = "most cells that the words of an entry begin too early or too late",
              .choices = ""},
    .limit_for = nullptr,
    .check = check,
};

}  // namespace tactics
