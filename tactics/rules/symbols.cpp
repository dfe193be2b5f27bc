// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/symbols.h"

#include <map>

#include "tactics/geometry/box.h"
#include "tactics/geometry/shape.h"

namespace tactics {

std::vector<Symbol> symbols_of(const PageGeometry& geometry) {
    // A symbol may touch the curve that it stands on, so connected figures do not help; the parts of a symbol touch each other.
    std::vector<Symbol> symbols;
    std::map<std::uint32_t, std::size_t> symbol_of;  // each chain's
    for (std::uint32_t c = 0; c < geometry.chains.size(); ++c) {
        const Chain& chain = geometry.chains[c];
        if (geometry.role_of(chain) != Role::symbol) continue;
        std::size_t at = symbols.size();
        for (const PageGeometry::Meets& meets : geometry.contacts_of[c]) {
            const Contact& contact = geometry.contacts[meets.contact];
            const auto other = static_cast<std::uint32_t>(meets.turned ? contact.one.chain : contact.other.chain);
            if (const auto found = symbol_of.find(other); found != symbol_of.end()) at = found->second;
        }
        if (at > 0 && chain.ring && symbols.size() == at) {  // a hole in the area before it
            const Chain& first = geometry.chains[symbols.back().chains[0]];
            if (first.ring && first.owner == chain.owner) at = symbols.size() - 1;
        }
        symbol_of[c] = at;
        if (at == symbols.size()) symbols.emplace_back();
        symbols[at].chains.push_back(c);
    }
    for (Symbol& symbol : symbols) {
        std::vector<Point> points;
        double widest = 0;
        bool filled = false, closed = false;
        for (const std::uint32_t c : symbol.chains) {
            const Chain& chain = geometry.chains[c];
            const std::vector<Point> own = geometry.points_of(chain);
            points.insert(points.end(), own.begin(), own.end());
            widest = std::max(widest, 2 * chain.half_width);
            filled = filled || chain.ring;
            closed = closed || chain.closed;
        }
        symbol.middle = rect_of(box_of(points)).middle();
        symbol.size = greatest_extent(points) + widest;
        symbol.kind = shape_of(points, closed).name;
        if (filled) symbol.kind = phrase("filled {0}", symbol.kind);
        if (symbol.chains.size() > 1) symbol.kind = phrase("{0} of {1} parts", symbol.kind, std::to_string(symbol.chains.size()));
    }
    return symbols;
}

}  // namespace tactics
