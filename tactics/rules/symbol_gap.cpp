// SPDX-License-Identifier: Apache-2.0
// Point symbols that stand too near to each other are felt as one.
#include <limits>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"
#include "tactics/rules/symbols.h"

namespace tactics {

namespace {

// Limit of examined pairs of pieces.
constexpr std::size_t kSymbolGapMostPairs = 100'000'000;

Findings check_symbol_gap(const PageGeometry& geometry, double limit) {
    Findings findings;
    const std::vector<Symbol> symbols = symbols_of(geometry);
    std::vector<std::size_t> piece;
    std::vector<std::size_t> symbol_of;
    std::vector<Box> boxes;
    for (std::size_t s = 0; s < symbols.size(); ++s)
        for (const std::uint32_t c : symbols[s].chains)
            for (std::size_t i = geometry.chains[c].first; i < geometry.chains[c].first + geometry.chains[c].count; ++i) {
                piece.push_back(i);
                symbol_of.push_back(s);
                boxes.push_back(geometry.box_of_piece(i, limit / 2));
            }
    std::vector<std::vector<std::pair<std::size_t, Nearest>>> near(symbols.size());  // of each, to later ones
    const Grid grid(std::move(boxes), geometry.page.width, geometry.page.height);
    findings.complete = grid.pairs(kSymbolGapMostPairs, [&](std::size_t i, std::size_t j) {
        if (symbol_of[i] == symbol_of[j]) return true;
        const Piece &p = geometry.pieces[piece[i]], &q = geometry.pieces[piece[j]];
        Nearest apart = nearest(p.line, q.line);
        apart.distance -= geometry.chains[p.chain].half_width + geometry.chains[q.chain].half_width;
        if (apart.distance >= limit - kRounding) return true;
        auto& known = near[std::min(symbol_of[i], symbol_of[j])];
        const std::size_t other = std::max(symbol_of[i], symbol_of[j]);
        for (auto& [symbol, best] : known)
            if (symbol == other) {
                if (apart.distance < best.distance) best = apart;
                return true;
            }
        known.emplace_back(other, apart);
        return true;
    });
    for (const auto& each : near)
        for (const auto& [other, apart] : each) {
            const double gap = std::max(0.0, apart.distance);
            findings.places.push_back({gap, apart.one, apart.other, phrase("two point symbols {0} mm apart", shown(gap))});
        }
    return findings;
}

}  // namespace

extern const Rule symbol_gap_rule;
const Rule symbol_gap_rule{
    .name = "symbol-gap",
    .summary = "point symbols stand apart",
    .mend = "move them apart, leave some out or take a larger scale",
    .source = "one project's reading of the Guidelines and Standards for Tactile Graphics 2022",
    .confidence = Confidence::uncertain,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 6,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum distance between two point symbols, edge to edge"},
    .check = check_symbol_gap,
};

}  // namespace tactics
