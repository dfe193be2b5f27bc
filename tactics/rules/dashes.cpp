// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/dashes.h"

#include "tactics/geometry/dashed_line.h"

namespace tactics {

double dash_gap(const PageGeometry& geometry, std::size_t dash, std::size_t next) {
    const Chain &a = geometry.chains[dash], &b = geometry.chains[next];
    return distance(geometry.point_at({dash, a.length}), geometry.point_at({next, 0})) - a.half_width - b.half_width;
}

std::vector<DashedLine> dashed_lines(const PageGeometry& geometry) {
    std::vector<DashedLine> lines;
    for (std::size_t c = 0; c < geometry.chains.size(); ++c) {
        const Chain& chain = geometry.chains[c];
        if (chain.ring || geometry.role_of(chain) != Role::dash || is_dot(chain)) continue;
        const bool same = !lines.empty() && lines.back().back() + 1 == c &&
                          geometry.chains[c - 1].half_width == chain.half_width &&
                          dash_gap(geometry, c - 1, c) <= kSameLine * felt_length(geometry.chains[c - 1]) &&
                          goes_on(geometry.points_of(geometry.chains[c - 1]), geometry.points_of(chain));
        if (!same) lines.emplace_back();
        lines.back().push_back(c);
    }
    return lines;
}

}  // namespace tactics
