// SPDX-License-Identifier: Apache-2.0
// An arrow that ends too near before what it points to would lose its head there.
#include <algorithm>
#include <optional>

#include "tactics/repair/means.h"
#include "tactics/rules/arrows.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

constexpr double kRoomAhead = 0.05;  // mm more than the rule asks
constexpr double kMostTimes = 2;     // of the gap, that a head is drawn back: towards a slanting line it takes more
constexpr double kLeastShaft = 3;    // mm that are left of it behind the head; own choice

double along(Point forward, Point from, Point to) { return (to.x - from.x) * forward.x + (to.y - from.y) * forward.y; }

// How far back the head has its gap; nothing if that is too far. What touches is one thing with what it points to, as it was
// drawn.
std::optional<double> way_back(ArrowTargets& targets, const ArrowHead& head, double gap) {
    constexpr int kSteps = 6;
    constexpr double kLeastGain = 0.3;  // of each mm
    Point tip = head.tip;
    double back = 0;
    for (int step = 0; step < kSteps; ++step) {
        const auto target = targets.before(head, tip, gap + kRoomAhead);
        if (!target || target->gap >= gap) return back;
        if (step == 0 && target->gap <= kTouch) return 0;
        const double apart = distance(target->at, tip);
        const double gain = apart > 0 ? along(head.forward, tip, target->at) / apart : 1;
        back += (gap + kRoomAhead - target->gap) / std::max(kLeastGain, gain);
        if (back > kMostTimes * gap) return std::nullopt;
        tip = {head.tip.x - back * head.forward.x, head.tip.y - back * head.forward.y};
    }
    return std::nullopt;
}

// The end of a line that is beyond the tip goes. `first`: its first end.
void end_at(std::vector<Point>& points, bool first, Point tip, Point forward) {
    if (first) std::reverse(points.begin(), points.end());
    while (points.size() > 2 && along(forward, tip, points[points.size() - 2]) > 0) points.pop_back();
    Point& end = points.back();
    const Point& before = points[points.size() - 2];
    const double beyond = along(forward, tip, end), behind = along(forward, tip, before);
    if (beyond > 0 && behind < 0) {
        const double share = beyond / (beyond - behind);
        end = {end.x + share * (before.x - end.x), end.y + share * (before.y - end.y)};
    }
    if (first) std::reverse(points.begin(), points.end());
}

}  // namespace

Mends draw_back_heads(Drawing& drawing, const Medium& medium, Seen& seen) {
    const PageGeometry& geometry = seen.geometry;
    const auto gap = limit_of(*find_rule("arrow-gap"), medium);
    const std::vector<std::uint32_t> heads = chains_with(geometry, Role::arrow);
    Mends changes;
    if (!gap || heads.empty()) return changes;
    ArrowTargets targets(geometry);
    for (const std::uint32_t c : heads) {
        const auto head = arrow_head(geometry, c);
        if (!head) continue;
        const auto back = way_back(targets, *head, *gap);
        if (!back || *back == 0) continue;
        const Point tip{head->tip.x - *back * head->forward.x, head->tip.y - *back * head->forward.y};
        Stroke& own = drawing.strokes[geometry.chains[c].owner];
        const double high = along(head->forward, own.points.front(), head->tip);
        std::vector<std::uint32_t> shafts;
        for (std::uint32_t other = 0; other < geometry.chains.size(); ++other)
            if (other != c && targets.is_shaft(*head, other)) shafts.push_back(other);
        if (std::any_of(shafts.begin(), shafts.end(), [&](std::uint32_t shaft) {
                return length_of(drawing.strokes[geometry.chains[shaft].owner]) < *back + high + kLeastShaft;
            }))
            continue;
        for (Point& p : own.points) p = {p.x - *back * head->forward.x, p.y - *back * head->forward.y};
        for (const std::uint32_t shaft : shafts) {
            std::vector<Point>& points = drawing.strokes[geometry.chains[shaft].owner].points;
            end_at(points, distance(points.front(), head->tip) < distance(points.back(), head->tip), tip, head->forward);
        }
        changes.push_back({Mend::Kind::shortened, tip, *back});
    }
    return changes;
}

}  // namespace tactics
