// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/arrows.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tactics {

namespace {

std::vector<Box> boxes_of_pieces(const PageGeometry& geometry) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < geometry.pieces.size(); ++i) boxes.push_back(geometry.box_of_piece(i, 0));
    return boxes;
}

}  // namespace

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

ArrowTargets::ArrowTargets(const PageGeometry& geometry)
    : geometry_(geometry), grid_(boxes_of_pieces(geometry), geometry.page.width, geometry.page.height) {}

bool ArrowTargets::is_shaft(const ArrowHead& head, std::uint32_t c) const {
    const Chain& chain = geometry_.chains[c];
    if (chain.ring || chain.closed) return false;
    const double reach = chain.half_width + geometry_.chains[head.chain].half_width + geometry_.chains[head.chain].length / 2;
    for (const double end : {0.0, chain.length}) {
        const Point at = geometry_.point_at({c, end}),
                    before = geometry_.point_at({c, end == 0 ? std::min(chain.length, 5.0) : std::max(0.0, end - 5.0)});
        const double way = (head.tip.x - before.x) * head.forward.x + (head.tip.y - before.y) * head.forward.y;
        if (distance(at, head.tip) <= reach && way > 0.7 * distance(head.tip, before)) return true;
    }
    return false;
}

std::optional<ArrowTargets::Target> ArrowTargets::before(const ArrowHead& head, Point tip, double reach) {
    const double own = geometry_.chains[head.chain].half_width;
    std::optional<Target> target;
    grid_.any_near(box_of({tip, tip}, own + reach), [&](std::size_t i) {
        if (budget_ == 0) return true;
        --budget_;
        const Piece& piece = geometry_.pieces[i];
        if (piece.chain == head.chain || is_shaft(head, piece.chain)) return false;
        const Point at = nearest_on(piece.line, tip);
        const double gap = distance(at, tip) - own - geometry_.chains[piece.chain].half_width;
        // Beside and behind the tip the rule for gaps looks.
        const double ahead = (at.x - tip.x) * head.forward.x + (at.y - tip.y) * head.forward.y;
        if (ahead >= -own && gap < reach && (!target || gap < target->gap)) target = {gap, at};
        return false;
    });
    return target;
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
