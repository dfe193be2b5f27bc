// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/parted.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/geometry/vectors.h"

namespace tactics {

namespace {

constexpr int kMostSteps = 200;
constexpr int kMostRounds = 16;
constexpr int kSmallerGaps = 3;     // rounds in which gaps become smaller, before things stay where they are
constexpr double kNearly = 0.15;    // of the gap, by which it may be too small without a need to move anything
constexpr double kEnough = 0.01;    // of the gap, by which one may be too small
constexpr double kLeastGap = 0.25;  // of the gap: where there is no room even for that, all stays as it is
constexpr double kInLine = 0.1;     // of the gap: middles that are nearer along an axis have no order there

// The least room that a shape must have to a side of what holds it.
struct HolderSide {
    Point out;  // of length 1
    double at = 0, least = 0;
};

struct PartedPiece {
    Convex hull;
    Box box;
    double area = 0, most = 0;
    Point by{};
    std::vector<HolderSide> sides = {};

    void shift(Point more) {
        for (Point& at : hull) at = {at.x + more.x, at.y + more.y};
        box = box_of(hull);
        by = {by.x + more.x, by.y + more.y};
    }
    Point middle() const { return {(box.left + box.right) / 2, (box.top + box.bottom) / 2}; }
};

struct PartedPair {
    std::uint32_t one, other;
    double room, least;  // mm that it must have, now and at the very least
    double order[2];     // along x and y: 1: the one comes first, -1: the other does, 0: neither
};

class PartingShapes {
public:
    PartingShapes(const std::vector<PartedShape>& shapes, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                  const Convex* within, const PartingWish& wish)
        : wish_(wish) {
        if (wish.sideways) along_ = {1, 0};
        for (const PartedShape& shape : shapes) {
            pieces_.push_back({shape.hull, box_of(shape.hull), area_of(shape.hull), shape.most});
            if (within != nullptr && shape.most > 0) find_sides(pieces_.back(), *within);
        }
        for (const auto& [one, other] : pairs) find_pair(one, other);
    }

    std::vector<Point> moves() {
        const std::vector<PartedPiece> start = pieces_;
        std::vector<Point> by(pieces_.size());
        for (int round = 0; round < kMostRounds; ++round) {
            for (int step = 0; step < kMostSteps && moved_once(); ++step) {
            }
            const bool done = !eased(round < kSmallerGaps);
            for (std::size_t i = 0; i < pieces_.size(); ++i) {
                if (done) by[i] = pieces_[i].by;
                const double most = pieces_[i].most;
                pieces_[i] = start[i];
                pieces_[i].most = most;
            }
            if (done) break;
        }
        return by;
    }

private:
    void find_sides(PartedPiece& piece, const Convex& ring) const {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point side = ring[(i + 1) % ring.size()] - ring[i];
            const double length = std::hypot(side.x, side.y);
            if (!(length > 0)) continue;
            const Point out{side.y / length, -side.x / length}, in{-out.x, -out.y};
            if (wish_.sideways && std::abs(out.x) < 0.5) continue;
            const double at = reach_of(ring, out), room = at - reach_of(piece.hull, out);
            const double slack = room + reach_of(ring, in) - reach_of(piece.hull, in);
            // What is on the border, or over it, goes no farther out; what is near it goes in as far as it may.
            const double least = room <= wish_.touching ? room
                                 : room >= (1 - kNearly) * wish_.gap
                                     ? std::min(wish_.gap, room)
                                     : std::min({wish_.gap, std::max(slack, 0.0) / 2, room + 0.7 * piece.most});
            piece.sides.push_back({out, at, least});
        }
    }

    void find_pair(std::uint32_t one, std::uint32_t other) {
        const PartedPiece &a = pieces_[one], &b = pieces_[other];
        const double reach = wish_.gap + a.most + b.most;
        if (a.most + b.most <= 0 || !meet(grown(a.box, reach), b.box)) return;
        const double room = parting_of(a.hull, b.hull, along_).room;
        if (room >= reach) return;
        // What is nearly apart stays so, and nothing comes closer than it was.
        const bool nearly = room >= (1 - kNearly) * wish_.gap;
        PartedPair pair{one, other, nearly ? std::min(room, wish_.gap) : wish_.gap, 0, {}};
        pair.least = std::min(pair.room, std::max(kLeastGap * wish_.gap, room));
        const Point between = b.middle() - a.middle();
        for (const auto& [order, by] : {std::pair(&pair.order[0], between.x), std::pair(&pair.order[1], between.y)})
            *order = std::abs(by) > kInLine * wish_.gap ? std::copysign(1.0, by) : 0;
        pairs_.push_back(pair);
    }

    // How far two are from where they should be: too close, or one past the other.
    struct Lack {
        double by = 0;
        Point way{};
    };

    Lack lack_of(const PartedPair& pair) const {
        const PartedPiece &one = pieces_[pair.one], &other = pieces_[pair.other];
        const Point between = other.middle() - one.middle();
        Lack most;
        for (const auto& [order, by, way] :
             {std::tuple(pair.order[0], between.x, Point{1, 0}), std::tuple(pair.order[1], between.y, Point{0, 1})})
            if (-order * by > most.by) most = {-order * by, {order * way.x, order * way.y}};
        if (most.by > kEnough * wish_.gap) return most;
        if (!meet(grown(one.box, pair.room), other.box)) return {};
        const Parting parting = parting_of(one.hull, other.hull, along_);
        return {pair.room - parting.room, parting.way};
    }

    double lack_of(const PartedPiece& piece, const HolderSide& side) const {
        return reach_of(piece.hull, side.out) - side.at + side.least;
    }

    // False: there was no need to.
    bool moved_once() {
        bool moved = false;
        for (const PartedPair& pair : pairs_) {
            PartedPiece &one = pieces_[pair.one], &other = pieces_[pair.other];
            if (one.most + other.most <= 0) continue;
            const Lack lack = lack_of(pair);
            if (lack.by <= kEnough * wish_.gap) continue;
            moved = true;
            // The larger moves less.
            const double whole = one.area + other.area;
            const double share = one.most <= 0 ? 0 : other.most <= 0 ? 1 : whole > 0 ? other.area / whole : 0.5;
            one.shift({-share * lack.by * lack.way.x, -share * lack.by * lack.way.y});
            other.shift({(1 - share) * lack.by * lack.way.x, (1 - share) * lack.by * lack.way.y});
        }
        for (PartedPiece& piece : pieces_) {
            for (const HolderSide& side : piece.sides) {
                const double lack = piece.most > 0 ? lack_of(piece, side) : 0;
                if (lack <= kEnough * wish_.gap) continue;
                moved = true;
                const double by = wish_.sideways ? lack / std::abs(side.out.x) : lack;
                piece.shift({-by * side.out.x, wish_.sideways ? 0 : -by * side.out.y});
            }
            // It stays within its bound.
            const double far = std::hypot(piece.by.x, piece.by.y);
            if (far > piece.most) {
                const double back = piece.most / far - 1;
                piece.shift({back * piece.by.x, back * piece.by.y});
            }
        }
        return moved;
    }

    // Asks for less where there was no room, for a smaller gap as long as that is allowed; false: there was room for all.
    bool eased(bool smaller_gaps) {
        std::vector<std::uint32_t> staying;
        bool changed = false;
        for (PartedPair& pair : pairs_) {
            if (pieces_[pair.one].most + pieces_[pair.other].most <= 0) continue;
            if (lack_of(pair).by <= 2 * kEnough * wish_.gap) continue;
            changed = true;
            if (smaller_gaps && pair.room > pair.least)
                pair.room = std::max(pair.least, pair.room / 2);
            else
                staying.insert(staying.end(), {pair.one, pair.other});
        }
        for (std::uint32_t i = 0; i < pieces_.size(); ++i)
            for (const HolderSide& side : pieces_[i].sides)
                if (pieces_[i].most > 0 && lack_of(pieces_[i], side) > 2 * kEnough * wish_.gap) staying.push_back(i);
        for (const std::uint32_t i : staying) pieces_[i].most = 0;
        return changed || !staying.empty();
    }

    PartingWish wish_;
    Point along_{};  // the only way to move; zero: any
    std::vector<PartedPiece> pieces_;
    std::vector<PartedPair> pairs_;
};

}  // namespace

std::vector<Point> parted(const std::vector<PartedShape>& shapes, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                          const Convex* within, const PartingWish& wish) {
    return PartingShapes(shapes, pairs, within, wish).moves();
}

}  // namespace tactics
