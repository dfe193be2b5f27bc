// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "tactics/repair/means.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

constexpr double kAtEnd = 0.01;  // mm
// An end points at a line if it can reach it without turning by more than 60 degrees; its direction is that of its last 3 mm.
constexpr double kPoints = 0.5;
constexpr double kLastPart = 3;
// Nearer to touching than to standing clear.
constexpr double kNearly = 0.5;

struct Joint {
    Point to;
    double gap = 0;
};

bool points_to(const PageGeometry& geometry, const Station& end, double inwards, Point to) {
    const Point at = geometry.point_at(end), from = geometry.point_at({end.chain, end.along + inwards * kLastPart});
    const double last = distance(from, at), way = distance(at, to);
    if (last == 0 || way == 0) return false;
    return ((at.x - from.x) * (to.x - at.x) + (at.y - from.y) * (to.y - at.y)) / (last * way) >= kPoints;
}

}  // namespace

Mends join_ends(Drawing& drawing, const Medium& medium, Seen& seen) {
    const PageGeometry& geometry = seen.geometry;
    std::map<std::pair<std::size_t, bool>, Joint> joints;  // of a chain's beginning (true) or end
    struct Ends {
        Point begin, end;
    };
    std::vector<Ends> ends;  // of each chain
    for (const Chain& chain : geometry.chains)
        ends.push_back({geometry.pieces[chain.first].line.a, geometry.pieces[chain.first + chain.count - 1].line.b});
    const auto look = [&](std::size_t number, std::uint32_t piece, Point at, std::uint32_t other, Point to) {
        const std::uint32_t c = geometry.pieces[piece].chain;
        const Chain& chain = geometry.chains[c];
        if (chain.ring || chain.closed || chain.length < kLastPart) return;
        const double gap = distance(at, to) - chain.half_width - geometry.chains[geometry.pieces[other].chain].half_width;
        if (gap > kNearly * medium.gap) return;
        for (const bool begins : {true, false}) {
            if (distance(at, begins ? ends[c].begin : ends[c].end) > kAtEnd || !seen.near.is_too_close(number)) continue;
            const auto [known, fresh] = joints.try_emplace({c, begins}, Joint{to, gap});
            if (!fresh && known->second.gap > gap) known->second = {to, gap};
        }
    };
    for (std::size_t i = 0; i < seen.near.size(); ++i) {
        if (seen.near[i].white > kNearly * medium.gap + kRounding) continue;
        const NearPair pair = seen.near.pair(i);
        look(i, pair.one, pair.at, pair.other, pair.other_at);
        look(i, pair.other, pair.other_at, pair.one, pair.at);
    }
    Mends changes;
    std::vector<Point> reached;
    for (const auto& [end, joint] : joints) {
        const Station at{end.first, end.second ? 0 : geometry.chains[end.first].length};
        if (!points_to(geometry, at, end.second ? 1 : -1, joint.to)) continue;
        // If two ends meet, one is extended to the other.
        if (std::any_of(reached.begin(), reached.end(), [&](Point p) { return distance(p, geometry.point_at(at)) < kAtEnd; }))
            continue;
        reached.push_back(joint.to);
        auto& points = drawing.strokes[geometry.chains[end.first].owner].points;
        changes.push_back({Mend::Kind::joined, end.second ? points.front() : points.back(), joint.gap});
        points.insert(end.second ? points.begin() : points.end(), joint.to);
    }
    return changes;
}

}  // namespace tactics
