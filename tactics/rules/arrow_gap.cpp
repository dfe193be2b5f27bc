// SPDX-License-Identifier: Apache-2.0
// An arrow that touches the thing it points to cannot be distinguished from it.
#include <algorithm>
#include <limits>

#include "tactics/rules/arrows.h"
#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

// The shaft ends at the tip or between the barbs; it comes from behind.
bool is_shaft(const PageGeometry& geometry, const ArrowHead& head, std::uint32_t c) {
    const Chain& chain = geometry.chains[c];
    if (chain.ring || chain.closed) return false;
    const double reach = chain.half_width + geometry.chains[head.chain].half_width + geometry.chains[head.chain].length / 2;
    for (const double end : {0.0, chain.length}) {
        const Point at = geometry.point_at({c, end}),
                    before = geometry.point_at({c, end == 0 ? std::min(chain.length, 5.0) : std::max(0.0, end - 5.0)});
        const double way = (head.tip.x - before.x) * head.forward.x + (head.tip.y - before.y) * head.forward.y;
        if (distance(at, head.tip) <= reach && way > 0.7 * distance(head.tip, before)) return true;
    }
    return false;
}

Findings check_arrow_gap(const PageGeometry& geometry, double limit) {
    Findings findings;
    const std::vector<std::uint32_t> heads = chains_with(geometry, Role::arrow);
    if (heads.empty()) return findings;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < geometry.pieces.size(); ++i) boxes.push_back(geometry.box_of_piece(i, 0));
    const Grid grid(std::move(boxes), geometry.page.width, geometry.page.height);
    std::size_t budget = 100'000'000;
    for (const std::uint32_t c : heads) {
        const auto head = arrow_head(geometry, c);
        if (!head) continue;
        const double own = geometry.chains[c].half_width, reach = own + limit;
        Nearest target{std::numeric_limits<double>::infinity(), {}, {}};
        grid.any_near(box_of({head->tip, head->tip}, reach), [&](std::size_t i) {
            if (budget == 0) return true;
            --budget;
            const Piece& piece = geometry.pieces[i];
            if (piece.chain == c || is_shaft(geometry, *head, piece.chain)) return false;
            const Point at = nearest_on(piece.line, head->tip);
            const double apart = distance(at, head->tip) - own - geometry.chains[piece.chain].half_width;
            // Beside and behind the tip the rule for gaps looks.
            const double ahead = (at.x - head->tip.x) * head->forward.x + (at.y - head->tip.y) * head->forward.y;
            if (ahead >= -own && apart < target.distance) target = {apart, head->tip, at};
            return false;
        });
        if (target.distance >= limit - kRounding) continue;
        const double gap = std::max(0.0, target.distance);
        findings.places.push_back({gap, head->tip, target.other,
                                   gap > 0 ? phrase("an arrow that ends {0} mm before what it points to", shown(gap))
                                           : phrase("an arrow that touches what it points to")});
    }
    findings.complete = budget > 0;
    return findings;
}

}  // namespace

extern const Rule arrow_gap_rule;
const Rule arrow_gap_rule{
    .name = "arrow-gap",
    .summary = "arrows do not touch what they point to",
    .mend = "shorten the arrow",
    .source =
        "accessiblegraphics.org: arrows have open heads, which must not touch what they point to. The distance is the general "
        "minimum gap, 1/8 in",
    .confidence = Confidence::good,
    .limit = {.name = "least",
              .type = Option::Type::length,
              .fallback = 3.2,
              .min = 0.1,
              .max = 100,
              .unit = "mm",
              .summary = "minimum distance from the tip to what it points to"},
    .check = check_arrow_gap,
};

}  // namespace tactics
