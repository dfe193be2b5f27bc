// SPDX-License-Identifier: Apache-2.0
// A finger remembers few point symbols.
#include <algorithm>
#include <cmath>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"
#include "tactics/rules/symbols.h"

namespace tactics {

namespace {

// Symbols of one form that differ by less in size feel the same ("differ 25 to 30 %", a rule file after BANA).
constexpr double kOther = 1.25;

Findings check_symbol_kinds(const PageGeometry& geometry, double limit) {
    struct Kind {
        const Symbol* first;
        std::size_t count;
    };
    std::vector<Symbol> symbols = symbols_of(geometry);
    std::stable_sort(symbols.begin(), symbols.end(), [](const Symbol& a, const Symbol& b) { return a.size < b.size; });
    std::vector<Kind> kinds;
    for (const Symbol& symbol : symbols) {
        const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) {
            return kind.first->kind == symbol.kind && symbol.size < kOther * kind.first->size;
        });
        if (same != kinds.end())
            ++same->count;
        else
            kinds.push_back({&symbol, 1});
    }
    const auto count = static_cast<double>(kinds.size());
    if (count <= limit) return {};
    const auto rarest =
        std::min_element(kinds.begin(), kinds.end(), [](const Kind& a, const Kind& b) { return a.count < b.count; });
    return {{{count,
              rarest->first->middle,
              {},
              phrase("{0} kinds of point symbols, the rarest, a {1}, here", shown(count), rarest->first->kind)}}};
}

}  // namespace

extern const Rule symbol_kinds_rule;
const Rule symbol_kinds_rule{
    .name = "symbol-kinds",
    .summary = "few kinds of point symbols on one page",
    .mend = "use fewer kinds, or explain them in a key",
    .source = "Tactile Graphics wiki, Design Considerations: at most 5 point symbols, else a key",
    .confidence = Confidence::medium,
    .limit = {.name = "most",
              .type = Option::Type::whole,
              .fallback = 5,
              .min = 1,
              .max = 100,
              .summary = "maximum number of kinds of point symbols on a page"},
    .check = check_symbol_kinds,
};

}  // namespace tactics
