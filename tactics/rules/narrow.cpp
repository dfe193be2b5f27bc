// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/narrow.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <unordered_map>

#include "tactics/rules/ink_way.h"

namespace tactics {

namespace {

constexpr std::size_t kMostNear = 100'000'000;
// Pairs near enough for a closer examination.
constexpr std::size_t kMostCandidates = 1'000'000;

// Mm by which sums of lengths may be off.
constexpr double kSure = 1e-9;

struct Candidate {
    double apart;
    Point one, other;
};

Point towards(Point from, Point to, double by) {
    const double length = distance(from, to);
    return length > 0 ? Point{from.x + (to.x - from.x) / length * by, from.y + (to.y - from.y) / length * by} : from;
}

// "two lines", "a line and an area", "two parts of a line"
Phrase pair_words(const Chain& one, const Chain& other, bool same) {
    if (same) return one.ring ? phrase("two parts of an area's edge") : phrase("two parts of a line");
    if (one.ring != other.ring) return phrase("a line and an area");
    return one.ring ? phrase("two areas") : phrase("two lines");
}

}  // namespace

class NarrowSearch {
public:
    NarrowSearch(const PageGeometry& geometry, double limit, Apart apart, const Vicinity* where)
        : geometry_(geometry),
          limit_(limit),
          apart_(apart),
          grid_(boxes(geometry, limit), geometry.page.width, geometry.page.height),
          ways_(geometry) {
        middles_.reserve(geometry.pieces.size());
        halves_.reserve(geometry.pieces.size());
        for (const Piece& piece : geometry.pieces) {
            middles_.push_back(middle_of(piece.line));
            halves_.push_back(distance(piece.line.a, piece.line.b) / 2);
        }
        patterns_.reserve(geometry.chains.size());
        for (const Chain& chain : geometry.chains) {
            patterns_.push_back(geometry.role_of(chain) == Role::pattern);
            any_area_ = any_area_ || chain.ring;
        }
        if (where == nullptr) return;
        within_.reserve(geometry.pieces.size());
        for (const Point& middle : middles_) within_.push_back(where->holds(middle));
    }

    // Calls take(i, j, nearest, measured) for all that are near enough, until it returns false; then that.
    template <typename Take>
    bool each_near(Take take) {
        return geometry_.complete && grid_.pairs(kMostNear, [&](std::size_t i, std::size_t j) {
            if (!within_.empty() && !within_[i] && !within_[j]) return true;
            ++looked_;
            if (is_far_or_bend(i, j)) return true;
            const Nearest near = nearest(geometry_.pieces[i].line, geometry_.pieces[j].line);
            const double ink = ink_of(i, j), measured = apart_ == Apart::edges ? near.distance - ink : near.distance;
            if (near.distance - ink <= kTouch || measured >= limit_ - kRounding) return true;
            return take(i, j, near, measured);
        });
    }

    // Those that is_far_or_bend says nothing of; false: there are too many.
    template <typename Take>
    bool suspects(Take take) {
        std::size_t count = 0;
        return geometry_.complete && grid_.pairs(kMostNear, [&](std::size_t i, std::size_t j) {
            ++looked_;
            if (is_far_or_bend(i, j)) return true;
            take(i, j);
            return ++count <= kMostCandidates;
        });
    }

    Findings places() {
        Findings findings;
        std::unordered_map<std::uint64_t, Candidate> narrowest;
        std::size_t asked = 0;
        findings.complete = each_near([&](std::size_t i, std::size_t j, const Nearest& near, double measured) {
            const std::uint32_t a = geometry_.pieces[i].chain, b = geometry_.pieces[j].chain;
            const std::uint64_t pair = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
            const auto known = narrowest.find(pair);
            if (known != narrowest.end() && known->second.apart <= measured) return true;
            if (++asked > kMostCandidates) return false;
            if (!is_gap(i, j, near)) return !exhausted();
            const Segment white = white_between(i, j, near);
            narrowest[pair] = {measured, white.a, white.b};
            return narrowest.size() <= kMostPlaces;
        });
        for (const auto& [pair, best] : narrowest) {
            const std::size_t a = pair >> 32, b = pair & 0xffffffff;
            findings.places.push_back(
                {best.apart, best.one, best.other, pair_words(geometry_.chains[a], geometry_.chains[b], a == b)});
        }
        // The map has no order; two places at one point are distinguished by their sizes.
        std::sort(findings.places.begin(), findings.places.end(), [](const Finding& a, const Finding& b) {
            return std::tie(a.at.y, a.at.x, a.measured, a.other->y, a.other->x) <
                   std::tie(b.at.y, b.at.x, b.measured, b.other->y, b.other->x);
        });
        return findings;
    }

    double ink_of(std::size_t i, std::size_t j) const {
        return geometry_.chains[geometry_.pieces[i].chain].half_width + geometry_.chains[geometry_.pieces[j].chain].half_width;
    }

    // A bend, as an earlier search shows wherever on the two pieces they are nearest. Needs no nearest places.
    bool is_known_bend(std::size_t i, std::size_t j, double apart) {
        const Piece &p = geometry_.pieces[i], &q = geometry_.pieces[j];
        const double beside = halves_[i] + halves_[j];
        return ways_.known_within({p.chain, p.along + halves_[i]}, {q.chain, q.along + halves_[j]},
                                  kBend * apart - beside - kSure);
    }

    // It is white between the two, and no bend. The cheapest question first.
    bool is_gap(std::size_t i, std::size_t j, const Nearest& near) {
        const Piece &p = geometry_.pieces[i], &q = geometry_.pieces[j];
        const Station from{p.chain, p.along + distance(p.line.a, near.one)},
            to{q.chain, q.along + distance(q.line.a, near.other)};
        const Segment white = white_between(i, j, near);
        if (any_area_ && leads_through_black(white)) return false;
        const double bend = kBend * near.distance;
        if (ways_.known_within(from, to, bend)) return false;
        if (is_covered(white, p.chain, q.chain)) return false;
        if (ways_.may_join(i, j, bend) && ways_.joined_within(from, to, bend)) return false;
        return !ways_.exhausted();
    }

    bool exhausted() const { return ways_.exhausted(); }
    std::size_t work() const { return looked_ + ways_.work(); }

private:
    static std::vector<Box> boxes(const PageGeometry& geometry, double limit) {
        std::vector<Box> all;
        all.reserve(geometry.pieces.size());
        for (std::size_t i = 0; i < geometry.pieces.size(); ++i) all.push_back(geometry.box_of_piece(i, limit / 2));
        return all;
    }

    // Most pairs are dismissed quickly: too far apart, or parts of one line or of two that touch, with a bend between them.
    bool is_far_or_bend(std::size_t i, std::size_t j) const {
        const Piece &p = geometry_.pieces[i], &q = geometry_.pieces[j];
        const bool one = patterns_[p.chain], other = patterns_[q.chain];
        if (apart_ == Apart::edges ? one || other : one && other) return true;
        const double ink = ink_of(i, j), least = distance(middles_[i], middles_[j]) - halves_[i] - halves_[j];
        if (least - (apart_ == Apart::edges ? ink : 0) >= limit_) return true;
        const double bend = kBend * std::max(ink + kTouch, least);
        if (p.chain == q.chain)
            return geometry_.way(geometry_.chains[p.chain], p.along, q.along) + geometry_.longest_piece < bend;
        return ways_.touch_within({p.chain, p.along + halves_[i]}, {q.chain, q.along + halves_[j]},
                                  bend - halves_[i] - halves_[j] - kSure);
    }

    Segment white_between(std::size_t i, std::size_t j, const Nearest& near) const {
        return {towards(near.one, near.other, geometry_.chains[geometry_.pieces[i].chain].half_width),
                towards(near.other, near.one, geometry_.chains[geometry_.pieces[j].chain].half_width)};
    }

    // At both ends, where it may lead into the area that the edge belongs to, and in the middle.
    bool leads_through_black(const Segment& between) const {
        for (const double t : {0.02, 0.5, 0.98})
            if (geometry_.black_area_at(
                    {between.a.x + t * (between.b.x - between.a.x), between.a.y + t * (between.b.y - between.a.y)}))
                return true;
        return false;
    }

    bool is_covered(const Segment& between, std::uint32_t one, std::uint32_t other) {
        const Point middle = middle_of(between);
        const double reach = distance(between.a, between.b) / 2 + kSure;
        return geometry_.ink.any_near(box_of(between, 0), [&](std::size_t k) {
            ++looked_;
            const Piece& third = geometry_.pieces[k];
            if (third.chain == one || third.chain == other) return false;
            const double half_width = geometry_.chains[third.chain].half_width,
                         off = distance(middle, nearest_on(third.line, middle));
            if (off < half_width - 1e-6) return true;
            if (off > half_width + reach) return false;
            const double apart = nearest(between, third.line).distance;
            return half_width > 0 ? apart < half_width - 1e-6 : apart == 0;
        });
    }

    const PageGeometry& geometry_;
    double limit_;
    Apart apart_;
    Grid grid_;
    std::vector<Point> middles_;  // of pieces
    std::vector<double> halves_;  // half their lengths, mm
    std::vector<bool> within_;    // pieces that are where it is looked; empty: all are
    std::vector<bool> patterns_;  // chains that are marks of a texture
    bool any_area_ = false;
    std::size_t looked_ = 0;
    InkWays ways_;
};

Findings narrow_places(const PageGeometry& geometry, double limit, Apart apart) {
    return NarrowSearch(geometry, limit, apart, nullptr).places();
}

NarrowSuspects::NarrowSuspects(const PageGeometry& geometry, double limit, Apart apart, const Vicinity* where)
    : geometry_(geometry), apart_(apart), search_(std::make_unique<NarrowSearch>(geometry, limit, apart, where)) {
    complete_ = search_->each_near([this](std::size_t i, std::size_t j, const Nearest&, double measured) {
        all_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), measured});
        return all_.size() <= kMostCandidates;
    });
    told_.resize(all_.size());
}

NarrowSuspects::~NarrowSuspects() = default;
NarrowSuspects::NarrowSuspects(NarrowSuspects&&) noexcept = default;

bool NarrowSuspects::is_narrow(std::size_t number) {
    Told& told = told_[number];
    if (told == Told::nothing) {
        const auto [i, j, measured] = all_[number];
        const double apart = apart_ == Apart::edges ? measured + search_->ink_of(i, j) : measured;
        if (search_->is_known_bend(i, j, apart)) {
            told = Told::no;
            return false;
        }
        told = search_->is_gap(i, j, nearest(geometry_.pieces[i].line, geometry_.pieces[j].line)) ? Told::yes : Told::no;
    }
    return told == Told::yes;
}

bool NarrowSuspects::complete() const { return complete_ && !search_->exhausted(); }

MovingNarrowPairs::MovingNarrowPairs(const PageGeometry& geometry, double limit, Apart apart, double moves)
    : geometry_(geometry),
      limit_(limit),
      apart_(apart),
      search_(std::make_unique<NarrowSearch>(geometry, limit + 2 * moves, apart, nullptr)),
      complete_(search_->suspects([this](std::size_t i, std::size_t j) {
          suspects_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), Told::nothing});
      })) {}

MovingNarrowPairs::~MovingNarrowPairs() = default;
MovingNarrowPairs::MovingNarrowPairs(MovingNarrowPairs&&) noexcept = default;

NarrowPairs MovingNarrowPairs::pairs(std::span<const Segment> now, std::size_t most) {
    NarrowPairs found;
    const std::size_t before = search_->work();
    std::vector<Point> middles;
    std::vector<double> halves;
    middles.reserve(now.size());
    halves.reserve(now.size());
    for (const Segment& piece : now) {
        middles.push_back(middle_of(piece));
        halves.push_back(distance(piece.a, piece.b) / 2);
    }
    for (Suspect& suspect : suspects_) {
        if (suspect.told == Told::none) continue;
        const std::size_t i = suspect.one, j = suspect.other;
        const double ink = search_->ink_of(i, j), reach = halves[i] + halves[j] + limit_ + (apart_ == Apart::edges ? ink : 0);
        const double dx = middles[i].x - middles[j].x, dy = middles[i].y - middles[j].y;
        if (dx * dx + dy * dy >= reach * reach) continue;
        const Nearest near = nearest(now[i], now[j]);
        const double measured = apart_ == Apart::edges ? near.distance - ink : near.distance;
        if (near.distance - ink <= kTouch || measured >= limit_ - kRounding) continue;
        if (suspect.told == Told::nothing)
            suspect.told =
                search_->is_gap(i, j, nearest(geometry_.pieces[i].line, geometry_.pieces[j].line)) ? Told::gap : Told::none;
        if (suspect.told == Told::none) continue;
        found.pairs.push_back({suspect.one, suspect.other, measured, near.one, near.other});
        if (found.pairs.size() > most) break;
    }
    found.complete = complete_ && !search_->exhausted();
    found.work = suspects_.size() + search_->work() - before;
    return found;
}

double reach_of_change(const PageGeometry& geometry, double limit) {
    double widest = 0;
    for (const Chain& chain : geometry.chains) widest = std::max(widest, 2 * chain.half_width);
    return kBend / 2 * (limit + widest) + geometry.longest_piece;
}

}  // namespace tactics
