// SPDX-License-Identifier: Apache-2.0
// A tick mark is found from both sides of its axis.
#include <algorithm>
#include <map>

#include "tactics/rules/arrows.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

Findings check_tick_sides(const PageGeometry& geometry, double limit) {
    Findings findings;
    for (const std::uint32_t c : chains_with(geometry, Role::tick)) {
        const Chain& chain = geometry.chains[c];
        // The meeting with each other line: the nearest contact of their pieces.
        std::map<std::size_t, std::pair<double, double>> axes;  // chain: how near, where along the tick
        for (const PageGeometry::Meets& meets : geometry.contacts_of[c]) {
            const Contact& contact = geometry.contacts[meets.contact];
            const std::size_t other = meets.turned ? contact.one.chain : contact.other.chain;
            if (geometry.chains[other].ring || geometry.role_of(geometry.chains[other]) == Role::tick) continue;
            const std::pair<double, double> here{contact.apart, meets.along};
            const auto [known, fresh] = axes.emplace(other, here);
            if (!fresh && here.first < known->second.first) known->second = here;
        }
        // The axis is the line that divides it best; it may meet other things, too.
        double best = -1;
        for (const auto& [other, where] : axes)
            best = std::max(best, std::min(where.second, chain.length - where.second) + chain.half_width);
        if (best < 0 || best >= limit - kRounding) continue;  // what meets nothing stands at no axis
        findings.places.push_back({best,
                                   geometry.point_at({c, chain.length / 2}),
                                   {},
                                   phrase("a tick mark {0} mm long on one side of its axis", shown(best))});
    }
    return findings;
}

}  // namespace

extern const Rule tick_sides_rule;
const Rule tick_sides_rule{
    .name = "tick-sides",
    .summary = "tick marks reach to both sides of their axis",
    .mend = "draw them as long on the other side",
    .source =
        "NBA Tactile Graphics Committee on BANA 3.4.3.4 and 6.6.2.2: tick marks are 1/2 in long in total, 1/4 in on each side "
        "of the axis",
    .confidence = Confidence::good,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 6.35,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum length of a tick mark on each side of the axis"},
    .check = check_tick_sides,
};

}  // namespace tactics
