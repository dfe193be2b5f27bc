// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/joined_sides.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "tactics/solid/largest_first.h"

namespace tactics {

namespace {

constexpr double kStraightOn = 0.7;  // cosine of the turn up to which a line goes on through a meeting of several

// A part of a straight line, mm from its origin.
struct SideStretch {
    double from, to;
    LineClass line;
    bool twice;
};

// 0 to pi: whichever way it is gone.
double angle_of(const DrawnSide& side) {
    constexpr double kAlike = 1e-6;
    double angle = std::atan2(side.to.y - side.from.y, side.to.x - side.from.x);
    if (angle < -kAlike) angle += std::numbers::pi;
    return angle >= std::numbers::pi - kAlike ? angle - std::numbers::pi : angle;
}

std::vector<SideStretch> put_together(const std::vector<SideStretch>& stretches, double touching) {
    std::vector<double> begins;
    for (const SideStretch& one : stretches) begins.push_back(one.from);
    make_alike(begins, 0, touching);
    std::vector<std::size_t> order(stretches.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return begins[a] < begins[b]; });
    std::vector<SideStretch> whole;
    for (const std::size_t next : order) {
        SideStretch one = stretches[next];
        if (whole.empty() || one.from > whole.back().to + touching) {
            whole.push_back(one);
            continue;
        }
        SideStretch& last = whole.back();
        const bool overlap = one.from <= last.to - touching, alike = one.twice == last.twice && one.line == last.line;
        if (!overlap && !alike) {
            whole.push_back(one);
        } else if (overlap && one.to > last.to + touching && one.twice != last.twice) {
            one.from = last.to;
            whole.push_back(one);
        } else {
            last.from = std::min(last.from, one.from);
            last.to = std::max(last.to, one.to);
            last.twice = last.twice && one.twice;
            last.line = std::max(last.line, one.line);
        }
    }
    return whole;
}

// Where sides meet.
class Joints {
public:
    Joints(const std::vector<DrawnSide>& sides, double grain) : sides_(sides), grain_(grain), done_(sides.size(), 0) {
        for (const DrawnSide& side : sides) {
            links_.push_back({number(side.from), number(side.to)});
            at_.resize(places_.size());
            at_[links_.back().first].push_back(links_.size() - 1);
            at_[links_.back().second].push_back(links_.size() - 1);
        }
    }

    std::vector<Stroke> strokes() {
        std::vector<Stroke> strokes;
        for (std::size_t link = 0; link < links_.size(); ++link)
            for (const std::size_t end : {links_[link].first, links_[link].second})
                if (done_[link] == 0 && !next(end, link)) strokes.push_back(follow(link, end));
        for (std::size_t link = 0; link < links_.size(); ++link)
            if (done_[link] == 0) strokes.push_back(follow(link, links_[link].first));
        std::erase_if(strokes, [](const Stroke& stroke) { return stroke.points.size() < 2; });
        return strokes;
    }

private:
    using Key = std::pair<long long, long long>;

    std::size_t number(Point at) {
        const Key key{std::llround(at.x / grain_), std::llround(at.y / grain_)};
        for (long long i = -1; i <= 1; ++i)
            for (long long j = -1; j <= 1; ++j)
                if (const auto found = numbers_.find({key.first + i, key.second + j});
                    found != numbers_.end() && distance(places_[found->second], at) <= grain_)
                    return found->second;
        places_.push_back(at);
        return numbers_[key] = places_.size() - 1;
    }

    bool are_alike(std::size_t one, std::size_t other) const {
        return one != other && sides_[one].line == sides_[other].line && sides_[one].twice == sides_[other].twice;
    }

    // Cosine of the turn from one side into another.
    double straightness(std::size_t place, std::size_t one, std::size_t other) const {
        const auto away = [&](std::size_t link) {
            const Point far = places_[links_[link].first == place ? links_[link].second : links_[link].first];
            const double length = std::max(1e-300, distance(far, places_[place]));
            return Point{(far.x - places_[place].x) / length, (far.y - places_[place].y) / length};
        };
        const Point a = away(one), b = away(other);
        return -(a.x * b.x + a.y * b.y);
    }

    // Where many sides meet a line goes straight on.
    std::optional<std::size_t> straightest(std::size_t place, std::size_t link) const {
        std::optional<std::size_t> best;
        double most = kStraightOn;
        for (const std::size_t other : at_[place])
            if (const double straight = are_alike(link, other) ? straightness(place, link, other) : -1; straight > most + 1e-9) {
                most = straight;
                best = other;
            }
        return best;
    }

    std::optional<std::size_t> next(std::size_t place, std::size_t link) const {
        const std::vector<std::size_t>& here = at_[place];
        if (here.size() == 2) {
            const std::size_t other = here[0] == link ? here[1] : here[0];
            return are_alike(link, other) ? std::optional(other) : std::nullopt;
        }
        const auto other = straightest(place, link);
        return other && straightest(place, *other) == link ? other : std::nullopt;
    }

    Stroke follow(std::size_t link, std::size_t from) {
        Stroke stroke;
        stroke.points = {places_[from]};
        stroke.line = sides_[link].line;
        if (sides_[link].twice) stroke.role = Role::dash;
        for (std::size_t place = from;;) {
            done_[link] = 1;
            place = links_[link].first == place ? links_[link].second : links_[link].first;
            if (place == from) {
                stroke.closed = stroke.points.size() > 2;
                return stroke;
            }
            stroke.points.push_back(places_[place]);
            const auto on = next(place, link);
            if (!on || done_[*on] != 0) return stroke;
            link = *on;
        }
    }

    const std::vector<DrawnSide>& sides_;
    double grain_;
    std::map<Key, std::size_t> numbers_;
    std::vector<Point> places_;
    std::vector<std::pair<std::size_t, std::size_t>> links_;  // the places of each side's ends
    std::vector<std::vector<std::size_t>> at_;                // the sides at each place
    std::vector<char> done_;
};

}  // namespace

std::vector<DrawnSide> merged(const std::vector<DrawnSide>& sides, double touching) {
    constexpr double kAlike = 1e-4;  // radians
    std::vector<DrawnSide> result;
    std::vector<char> done(sides.size(), 0);
    // By direction, so that only neighbours are compared; of one direction in their order.
    std::vector<double> angles;
    for (const DrawnSide& side : sides) angles.push_back(angle_of(side));
    make_alike(angles, 0, kAlike / 10);
    std::vector<std::size_t> order(sides.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angles[a] < angles[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (done[order[i]] != 0) continue;
        const DrawnSide& first = sides[order[i]];
        const double length = distance(first.from, first.to);
        const Point along{(first.to.x - first.from.x) / length, (first.to.y - first.from.y) / length};
        const auto off = [&](Point at) { return std::abs((at.x - first.from.x) * along.y - (at.y - first.from.y) * along.x); };
        const auto on = [&](Point at) { return (at.x - first.from.x) * along.x + (at.y - first.from.y) * along.y; };
        std::vector<SideStretch> stretches;
        for (std::size_t j = i; j < order.size() && angles[order[j]] <= angles[order[i]] + kAlike; ++j) {
            const DrawnSide& other = sides[order[j]];
            if (done[order[j]] != 0 || off(other.from) > 2 * touching || off(other.to) > 2 * touching) continue;
            done[order[j]] = 1;
            const auto [from, to] = std::minmax({on(other.from), on(other.to)});
            stretches.push_back({from, to, other.line, other.twice});
        }
        for (const SideStretch& one : put_together(stretches, touching)) {
            const auto at = [&](double t) { return Point{first.from.x + t * along.x, first.from.y + t * along.y}; };
            result.push_back({at(one.from), at(one.to), one.line, one.twice});
        }
    }
    return result;
}

std::vector<Stroke> joined(const std::vector<DrawnSide>& sides, double touching) { return Joints(sides, 4 * touching).strokes(); }

}  // namespace tactics
