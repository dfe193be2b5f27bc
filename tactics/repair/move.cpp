// SPDX-License-Identifier: Apache-2.0
// Lines bend away from each other, as maps are displaced when they are drawn smaller: what is too close pushes, the push spreads
// along the line so that it stays smooth, and no point goes farther than a fingertip can tell.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tactics/geometry/course.h"
#include "tactics/geometry/places.h"
#include "tactics/repair/means.h"
#include "tactics/rules/rule.h"

namespace tactics {

namespace {

constexpr double kBendStep = 1;  // mm between the points of a line that may bend
constexpr int kRounds = 8;       // of pushing
// Two metres of line beside line. Where there is more, nothing has a place to go.
constexpr std::size_t kMostPairs = 12'000;
// The first rounds help most. Where each has so much to look at, black heaps of lines for the most part, there are fewer: each of
// these is about 30 ns.
constexpr std::size_t kMostWork = 12'000'000;
constexpr double kWorthwhile = 0.97;  // a round that leaves more than this of what was near is the last
constexpr int kSpread = 3;            // times that a push is shared with the neighbours, each round
// Pushes are smoothed, so the last hundredths would take many rounds: they aim so much farther.
constexpr double kSpare = 0.15;     // mm
constexpr double kTold = 0.1;       // mm: less is not worth a word
constexpr double kStraight = 0.05;  // mm that the points left out afterwards may be off

// As most lines end on others or are far from each other, only these are pushed: those that can be brought apart.
bool can_be_mended(const NearPair& pair) { return pair.lacks <= 2 * kFarthestMove; }

std::vector<Point> in_steps(const Stroke& stroke) {
    std::vector<Point> points;
    const std::size_t n = stroke.points.size(), sides = stroke.closed ? n : n - 1;
    for (std::size_t i = 0; i < sides; ++i) {
        const Point a = stroke.points[i], b = stroke.points[(i + 1) % n];
        const double side = distance(a, b);
        if (side == 0) continue;
        const auto cuts = static_cast<std::size_t>(std::ceil(side / kBendStep));
        for (std::size_t k = 0; k < cuts; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(cuts);
            points.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
    }
    if (!stroke.closed) points.push_back(stroke.points.back());
    return points;
}

std::size_t nearest_point(const std::vector<Point>& points, Point to) {
    const auto nearer = [to](Point a, Point b) { return distance(a, to) < distance(b, to); };
    return static_cast<std::size_t>(std::min_element(points.begin(), points.end(), nearer) - points.begin());
}

class Bending {
public:
    Bending(const Drawing& drawing, const Medium& medium) : medium_(medium), bent_(drawing) {
        for (Stroke& stroke : bent_.strokes)
            if (stroke.points.size() >= 2) stroke.points = in_steps(stroke);
        start_ = bent_;
        for (const Stroke& stroke : bent_.strokes) moved_.emplace_back(stroke.points.size());
    }

    void run() {
        const Page page = page_of(bent_, medium_);
        const PageGeometry geometry(page);
        find_anchors(geometry);
        MovingNearPairs moving(geometry, medium_, -kSpare, kFarthestMove);
        std::size_t work = 0;
        for (int round = 0;; ++round) {
            place_pieces(geometry);
            const NearPairs near = moving.pairs(now_, kMostPairs);
            work += near.work;
            const std::size_t last = left_;
            left_ = count_near(near.pairs);
            if (round == 0) {
                first_ = left_;
                troubled_ = troubled(geometry, near.pairs);
            } else if (static_cast<double>(left_) >= kWorthwhile * static_cast<double>(last)) {
                return;
            }
            const bool thicket = near.pairs.size() > kMostPairs;
            if (!near.complete || thicket || left_ == 0 || round == kRounds || work >= kMostWork) return;
            push(geometry, near.pairs);
        }
    }

    bool has_helped() const { return left_ < first_; }

    // The drawing with the strokes that moved, and what to say of them.
    Drawing result(const Drawing& drawing, Mends& changes) const {
        Drawing result = drawing;
        for (std::size_t s = 0; s < moved_.size(); ++s) {
            std::size_t most = 0;
            for (std::size_t i = 0; i < moved_[s].size(); ++i)
                if (size_of(moved_[s][i]) > size_of(moved_[s][most])) most = i;
            if (moved_[s].empty() || size_of(moved_[s][most]) < kRounding) continue;
            result.strokes[s].points = simplified(bent_.strokes[s]);
            if (size_of(moved_[s][most]) >= kTold)
                changes.push_back({Mend::Kind::moved, start_.strokes[s].points[most], size_of(moved_[s][most])});
        }
        if (!result.regions.empty()) take_along(result.regions);
        return result;
    }

private:
    // A place on a line goes where the line goes; of lines as near as each other with the first.
    void take_along(std::vector<Region>& regions) const {
        Box area = kNothing;
        for (const Stroke& stroke : start_.strokes)
            for (const Point& at : stroke.points) area.take(at);
        if (area.left > area.right) return;
        Places places(area, kBendStep);
        std::vector<Point> way;  // of each place
        for (std::size_t s = 0; s < moved_.size(); ++s)
            for (std::size_t i = 0; i < moved_[s].size(); ++i) {
                places.add(start_.strokes[s].points[i]);
                way.push_back(moved_[s][i]);
            }
        const auto gone_with = [&](Point at) {
            double nearest = kBendStep / 2;
            std::size_t by = way.size();
            places.any_near(at, nearest, [&](std::size_t number) {
                const double off = distance(places[number], at);
                if (off < nearest || (off == nearest && by != way.size() && number < by)) {
                    nearest = off;
                    by = number;
                }
                return false;
            });
            return by == way.size() ? at : Point{at.x + way[by].x, at.y + way[by].y};
        };
        for (Region& region : regions)
            for (auto& ring : region.rings)
                for (Point& at : ring) at = gone_with(at);
    }

    // Strokes that are too close to something. What is not pushes and is pushed only where it becomes so.
    std::vector<bool> troubled(const PageGeometry& geometry, const std::vector<NearPair>& pairs) const {
        std::vector<bool> strokes(bent_.strokes.size());
        for (const NearPair& pair : pairs)
            for (const std::uint32_t piece : {pair.one, pair.other})
                if (const Chain& chain = geometry.chains[geometry.pieces[piece].chain]; !chain.ring && pair.lacks > kRounding)
                    strokes[chain.owner] = true;
        return strokes;
    }

    bool is_end(const Chain& chain, Point at) const {
        constexpr double kThere = 0.01;
        if (chain.closed) return false;
        return distance(now_[chain.first].a, at) < kThere || distance(now_[chain.first + chain.count - 1].b, at) < kThere;
    }

    // A side of a stroke in steps is a piece; only where a line has so many that pieces are longer they stay where they were.
    static bool is_in_steps(const Chain& chain, const std::vector<Point>& points) {
        return !chain.ring && chain.count == (chain.closed ? points.size() : points.size() - 1);
    }

    // To where the lines are bent now.
    void place_pieces(const PageGeometry& geometry) {
        now_.resize(geometry.pieces.size());
        for (const Chain& chain : geometry.chains) {
            const auto& points = chain.ring ? std::vector<Point>{} : bent_.strokes[chain.owner].points;
            const bool moves = is_in_steps(chain, points);
            for (std::size_t i = 0; i < chain.count; ++i)
                now_[chain.first + i] =
                    moves ? Segment{points[i], points[(i + 1) % points.size()]} : geometry.pieces[chain.first + i].line;
        }
    }

    static std::size_t count_near(const std::vector<NearPair>& pairs) {
        return static_cast<std::size_t>(
            std::count_if(pairs.begin(), pairs.end(), [](const NearPair& pair) { return pair.lacks > 0; }));
    }

    static double size_of(Point p) { return std::hypot(p.x, p.y); }

    static std::vector<Point> simplified(const Stroke& stroke) {
        std::vector<bool> keep(stroke.points.size(), false);
        keep.front() = keep.back() = true;
        keep_course(stroke.points, 0, stroke.points.size() - 1, kStraight, keep);
        std::vector<Point> points;
        for (std::size_t i = 0; i < keep.size(); ++i)
            if (keep[i]) points.push_back(stroke.points[i]);
        return points.size() >= (stroke.closed ? 3u : 2u) ? points : stroke.points;
    }

    // An end that lies on another line goes where that line goes there.
    void find_anchors(const PageGeometry& geometry) {
        const auto look = [&](const Station& one, const Station& other) {
            const Chain &chain = geometry.chains[one.chain], &to = geometry.chains[other.chain];
            if (chain.ring || chain.closed || to.ring || one.chain == other.chain) return;
            const double reach = chain.half_width + to.half_width;
            const bool begins = one.along<reach, ends = one.along> chain.length - reach;
            if (begins == ends) return;
            const auto& points = bent_.strokes[to.owner].points;
            anchors_.push_back({chain.owner, begins ? 0 : moved_[chain.owner].size() - 1, to.owner,
                                nearest_point(points, geometry.point_at(other))});
        };
        for (const Contact& contact : geometry.contacts) {
            look(contact.one, contact.other);
            look(contact.other, contact.one);
        }
    }

    // The points at both ends of a piece are pushed alike.
    void push(const PageGeometry& geometry, const std::vector<NearPair>& pairs) {
        struct Push {
            Point sum;
            double count = 0;
        };
        std::vector<std::vector<Push>> pushes;
        for (const auto& points : moved_) pushes.emplace_back(points.size());
        const auto add = [&](std::uint32_t piece, Point at, Point from, double by) {
            const Chain& chain = geometry.chains[geometry.pieces[piece].chain];
            auto& own = pushes[chain.owner];
            if (!is_in_steps(chain, bent_.strokes[chain.owner].points)) return;
            const double apart = distance(at, from);
            if (apart == 0) return;
            for (const std::size_t i : {piece - chain.first, (piece - chain.first + 1) % own.size()}) {
                own[i].sum.x += (at.x - from.x) / apart * by;
                own[i].sum.y += (at.y - from.y) / apart * by;
                ++own[i].count;
            }
        };
        for (const NearPair& pair : pairs) {
            const Chain &a = geometry.chains[geometry.pieces[pair.one].chain],
                        &b = geometry.chains[geometry.pieces[pair.other].chain];
            const auto goes = [&](const Chain& chain) { return !chain.ring && troubled_[chain.owner]; };
            if (!can_be_mended(pair) || (pair.lacks <= 0 && !(goes(a) && goes(b)))) continue;
            // An end is shortened; no straight line gets a bump for it.
            if (is_end(a, pair.at) || is_end(b, pair.other_at)) continue;
            const double by = (pair.lacks + kSpare) * (a.ring || b.ring ? 1 : 0.5);
            if (!a.ring) add(pair.one, pair.at, pair.other_at, by);
            if (!b.ring) add(pair.other, pair.other_at, pair.at, by);
        }
        for (std::size_t s = 0; s < moved_.size(); ++s)
            for (std::size_t i = 0; i < moved_[s].size(); ++i)
                if (const Push& p = pushes[s][i]; p.count > 0) {
                    moved_[s][i].x += p.sum.x / p.count;
                    moved_[s][i].y += p.sum.y / p.count;
                }
        for (int i = 0; i < kSpread; ++i) {
            for (std::size_t s = 0; s < moved_.size(); ++s) spread(moved_[s], bent_.strokes[s].closed);
            for (const Anchor& anchor : anchors_) moved_[anchor.stroke][anchor.end] = moved_[anchor.on][anchor.there];
        }
        apply();
    }

    static void spread(std::vector<Point>& moved, bool closed) {
        const std::vector<Point> before = moved;
        const std::size_t n = moved.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (n < 3 || (!closed && (i == 0 || i + 1 == n))) continue;
            const Point &a = before[(i + n - 1) % n], &b = before[(i + 1) % n];
            moved[i] = {before[i].x / 2 + (a.x + b.x) / 4, before[i].y / 2 + (a.y + b.y) / 4};
        }
    }

    void apply() {
        for (std::size_t s = 0; s < moved_.size(); ++s)
            for (std::size_t i = 0; i < moved_[s].size(); ++i) {
                Point& by = moved_[s][i];
                if (const double size = size_of(by); size > kFarthestMove)
                    by = {by.x / size * kFarthestMove, by.y / size * kFarthestMove};
                const Point from = start_.strokes[s].points[i];
                // What was within the drawing stays there.
                const Point to{std::clamp(from.x + by.x, std::min(0.0, from.x), std::max(start_.width, from.x)),
                               std::clamp(from.y + by.y, std::min(0.0, from.y), std::max(start_.height, from.y))};
                by = {to.x - from.x, to.y - from.y};
                bent_.strokes[s].points[i] = to;
            }
    }

    struct Anchor {
        std::size_t stroke, end, on, there;
    };
    const Medium& medium_;
    Drawing start_, bent_;                   // strokes in steps
    std::vector<std::vector<Point>> moved_;  // each point so far
    std::vector<Anchor> anchors_;
    std::vector<bool> troubled_;
    std::size_t first_ = 0, left_ = 0;  // how much is too close before all bending, and by now
    std::vector<Segment> now_;          // where each piece of the lines in steps is by now
};

}  // namespace

std::optional<Mends> move_apart(Drawing& drawing, const Medium& medium) {
    Bending bending(drawing, medium);
    bending.run();
    if (!bending.has_helped()) return std::nullopt;
    Mends changes;
    drawing = bending.result(drawing, changes);
    return changes;
}

}  // namespace tactics
