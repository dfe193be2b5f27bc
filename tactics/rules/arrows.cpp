// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/arrows.h"

#include <cmath>

namespace tactics {

std::optional<ArrowHead> arrow_head(const PageGeometry& geometry, std::uint32_t c) {
    const Chain& chain = geometry.chains[c];
    if (chain.ring || chain.closed) return std::nullopt;
    // The tip is what is farthest from the line between the barbs' ends.
    const Point one = geometry.point_at({c, 0}), other = geometry.point_at({c, chain.length});
    const Point back{(one.x + other.x) / 2, (one.y + other.y) / 2};
    ArrowHead head{c, back, {}};
    double most = 0;
    for (const Point& p : geometry.points_of(chain)) {
        const double away = distance(p, nearest_on({one, other}, p));
        if (away <= most) continue;
        most = away;
        head.tip = p;
    }
    const double length = distance(back, head.tip);
    if (!(most > 0) || !(length > 0)) return std::nullopt;
    head.forward = {(head.tip.x - back.x) / length, (head.tip.y - back.y) / length};
    return head;
}

std::vector<std::uint32_t> chains_with(const PageGeometry& geometry, Role role) {
    std::vector<std::uint32_t> with;
    for (std::uint32_t c = 0; c < geometry.chains.size(); ++c) {
        const Chain& chain = geometry.chains[c];
        const bool again = c > 0 && chain.ring && geometry.chains[c - 1].ring && geometry.chains[c - 1].owner == chain.owner;
        if (geometry.role_of(chain) == role && !again) with.push_back(c);
    }
    return with;
}

}  // namespace tactics
