// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/proxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tactics {

namespace {

constexpr double kFar = 1e8;    // samples: a finger farther off is taken as there, so that squares stay finite and numbers whole
constexpr double kSame = 1e-9;  // samples: places nearer than that are one

int whole_below(double value) { return static_cast<int>(std::floor(value)); }

// Lines at whole numbers of one coordinate: across, down and, for the diagonals, across less down. Beside the map are none.
struct Lines {
    double step, from, slope, next;
    double line, last;
    Lines(double start, double way, int least, int most) noexcept : step(way < 0 ? -1 : 1), from(start), slope(1 / way) {
        last = way < 0 ? least : most;
        line = way < 0 ? std::min(std::ceil(start) - 1, 1.0 * most) : std::max(std::floor(start) + 1, 1.0 * least);
        next = way == 0 || (last - line) * step < 0 ? kNever : (line - from) * slope;
    }
    int cross() noexcept {
        const int crossed = static_cast<int>(line);
        next = line == last ? kNever : (line + step - from) * slope;
        line += step;
        return crossed;
    }
    static constexpr double kNever = std::numeric_limits<double>::infinity();
};

}  // namespace

Proxy::Proxy(const ReliefSurface& surface) noexcept
    : surface_(&surface),
      heights_(surface.map().heights.data()),
      last_column_(surface.map().columns - 1),
      last_row_(surface.map().rows - 1),
      pitch_(surface.map().pitch),
      per_mm_(1 / surface.map().pitch),
      lowest_(surface.lowest() * per_mm_),
      highest_(surface.highest() * per_mm_),
      last_{0, 0, surface.highest()} {}

// Beside the map as at its edge.
double Proxy::sample(int column, int row) const noexcept {
    const std::ptrdiff_t i = std::clamp(column, 0, last_column_), j = std::clamp(row, 0, last_row_);
    return static_cast<double>(heights_[j * (last_column_ + 1) + i]) * per_mm_;
}

bool Proxy::on_map(const Facet& facet) const noexcept {
    return facet.column >= 0 && facet.row >= 0 && facet.column < last_column_ && facet.row < last_row_;
}

Proxy::Facet Proxy::facet_at(double u, double v) const noexcept {
    const int column = std::clamp(whole_below(u), -1, last_column_), row = std::clamp(whole_below(v), -1, last_row_);
    return {column, row, u - column < v - row};
}

double Proxy::height_in(const Facet& facet, double u, double v) const noexcept {
    const double first = sample(facet.column, facet.row), last = sample(facet.column + 1, facet.row + 1);
    const double other = facet.lower ? sample(facet.column, facet.row + 1) : sample(facet.column + 1, facet.row);
    const double across = u - facet.column, down = v - facet.row;
    return facet.lower ? first + (last - other) * across + (other - first) * down
                       : first + (other - first) * across + (last - other) * down;
}

double Proxy::height(Point at) const noexcept {
    if (std::isnan(at.x) || std::isnan(at.y)) return surface_->lowest();
    const double u = std::clamp(at.x * per_mm_ - 0.5, -kFar, kFar), v = std::clamp(at.y * per_mm_ - 0.5, -kFar, kFar);
    return height_in(facet_at(u, v), u, v) * pitch_;
}

// It lies on that edge of its facet (numbers as in nearest), at `part` of it: what is on the other side.
void Proxy::set_border(Foot& foot, int edge, double part) noexcept {
    const bool lower = foot.beside.lower;
    if (part > 0 && part < 1) {
        foot.border = Border::edge;
        foot.beside.lower = !lower;
        if (edge == 0) --(lower ? foot.beside.column : foot.beside.row);
        if (edge == 1) ++(lower ? foot.beside.row : foot.beside.column);
        foot.column = foot.beside.column + (edge == 1 || (edge == 2 && lower) ? 1 : 0);
        foot.row = foot.beside.row + (edge == 1 || (edge == 2 && !lower) ? 1 : 0);
        return;
    }
    foot.border = Border::corner;
    const bool first = edge == 1 || part > 0, second = edge != 0 && part > 0;
    foot.beside.column += (lower ? second : first) ? 1 : 0;
    foot.beside.row += (lower ? first : second) ? 1 : 0;
}

// The facet with its corners O (0, 0), P (1, 0) and D (1, 1), its edges 0: O P, 1: P D, 2: O D; for the lower one across and down
// change their parts. A finger above the facet's plane meets only the upright sides of the column; any other meets the triangle.
Proxy::Foot Proxy::nearest(const Facet& facet, const Place& finger) const noexcept {
    const int column = facet.column, row = facet.row;
    const bool lower = facet.lower;
    if (!on_map(facet)) return nearest_beside(facet, finger);
    const float* const heights = heights_ + static_cast<std::ptrdiff_t>(row) * (last_column_ + 1) + column;
    const auto height_of = [&](std::ptrdiff_t index) { return static_cast<double>(heights[index]) * per_mm_; };
    const double zero = height_of(0), last = height_of(last_column_ + 2), other = height_of(lower ? last_column_ + 1 : 1);
    const double across = finger.u - column, down = finger.v - row;
    const double a = lower ? down : across, b = lower ? across : down, c = finger.w - zero;
    const double along = other - zero, aside = last - other;  // how the plane rises

    constexpr int kNone = -1;
    double qa = a, qb = b, best = 0, part = 0;
    int edge = kNone;
    const auto try_edge = [&](int which, double t, double rise) {
        t = t < kSame ? 0 : t > 1 - kSame ? 1 : t;
        const double ea = which == 1 ? 1 : t, eb = which == 0 ? 0 : t;
        const double squared = (a - ea) * (a - ea) + (b - eb) * (b - eb) + rise * rise;
        if (edge != kNone && squared >= best) return;
        best = squared;
        edge = which;
        part = t;
        qa = ea;
        qb = eb;
    };
    const auto foot = [&](double w, bool in_air) {
        Foot made{{column + (lower ? qb : qa), row + (lower ? qa : qb), w}, best, Border::none, facet, 0, 0, in_air};
        if (edge != kNone) set_border(made, edge, part);
        return made;
    };

    if (b < 0) try_edge(0, a, 0);
    if (a > 1) try_edge(1, b, 0);
    if (b > a) try_edge(2, (a + b) / 2, 0);
    if (c >= along * qa + aside * qb) return foot(finger.w, true);

    // Its foot on the plane or, outside the triangle, the nearest point of the edges beyond which it lies. On an edge the facet
    // behind it is also tried, regardless of rounding.
    const double steep = 1 + along * along + aside * aside, sunk = (along * a + aside * b - c) / steep;
    const double pa = a - along * sunk, pb = b - aside * sunk, both = along + aside;
    edge = kNone;
    const auto try_slope = [&](int which, double t, double start, double rise) {
        t = std::clamp(t, 0.0, 1.0);
        try_edge(which, t, c - start - rise * t);
    };
    if (pb < kSame) try_slope(0, (a + along * c) / (1 + along * along), 0, along);
    if (pa > 1 - kSame) try_slope(1, (b + aside * (c - along)) / (1 + aside * aside), along, aside);
    if (pb > pa - kSame) try_slope(2, (a + b + both * c) / (2 + both * both), 0, both);
    if (edge == kNone) {
        qa = pa;
        qb = pb;
        best = sunk * sunk * steep;
    }
    return foot(zero + along * qa + aside * qb, false);
}

// The same where the map is continued without an end: level away from it, and along its edge as that.
Proxy::Foot Proxy::nearest_beside(const Facet& facet, const Place& finger) const noexcept {
    const int column = facet.column, row = facet.row;
    const double first = sample(column, row);
    Foot foot{finger, 0, Border::none, facet, 0, 0, true};
    int across = 0, down = 0;  // the side at whose border it is
    const auto keep_beside = [](double& at, int index, int last, int& side) {
        if (index < 0 && at > -kSame) {
            at = 0;
            side = 1;
        } else if (index >= 0 && at < last + kSame) {
            at = last;
            side = -1;
        }
    };
    const auto keep_along = [&](double& at, int index, double rise, int& side) {
        const double a = at - index, c = finger.w - first;
        double t = std::clamp(a, 0.0, 1.0);
        if (c < rise * t) {
            t = std::clamp((a + rise * c) / (1 + rise * rise), 0.0, 1.0);
            foot.in_air = false;
        }
        side = t < kSame ? -1 : t > 1 - kSame ? 1 : 0;
        t = side < 0 ? 0 : side > 0 ? 1 : t;
        at = index + t;
        if (!foot.in_air) foot.place.w = first + rise * t;
    };
    const bool strip_across = column >= 0 && column < last_column_, strip_down = row >= 0 && row < last_row_;
    if (strip_across)
        keep_along(foot.place.u, column, sample(column + 1, row) - first, across);
    else
        keep_beside(foot.place.u, column, last_column_, across);
    if (strip_down)
        keep_along(foot.place.v, row, sample(column, row + 1) - first, down);
    else
        keep_beside(foot.place.v, row, last_row_, down);
    if (!strip_across && !strip_down && finger.w < first) {
        foot.place.w = first;
        foot.in_air = false;
    }
    const double du = finger.u - foot.place.u, dv = finger.v - foot.place.v, dw = finger.w - foot.place.w;
    foot.squared = du * du + dv * dv + dw * dw;
    if (across != 0 && down != 0) {
        foot.border = Border::corner;
        foot.beside = {column + (across > 0 ? 1 : 0), row + (down > 0 ? 1 : 0), false};
    } else if (across != 0 || down != 0) {
        foot.border = Border::edge;
        foot.beside = {column + across, row + down, across > 0 || down < 0};
    }
    return foot;
}

// Straight towards the finger until the surface or the end: both are straight between the borders that are crossed, so a gap that
// is open at each border is open between them. Gives whether the finger is reached.
bool Proxy::march(const Place& finger, int& steps) noexcept {
    const Place from = place_;
    const double du = finger.u - from.u, dv = finger.v - from.v, dw = finger.w - from.w;
    Lines columns(from.u, du, 0, last_column_), rows(from.v, dv, 0, last_row_),
        diagonals(from.u - from.v, du - dv, -last_row_, last_column_);
    double before = 0, gap_before = std::max(from.w - height_in(facet_, from.u, from.v), 0.0);
    for (;;) {
        const double now = std::min({columns.next, rows.next, diagonals.next, 1.0});
        const double u = from.u + du * now, v = from.v + dv * now, w = from.w + dw * now;
        double surface = 0;
        const bool end = now >= 1;
        if (end) {
            surface = height_in(facet_at(finger.u, finger.v), finger.u, finger.v);
        } else if (now == columns.next) {
            const int column = columns.cross(), row = whole_below(v);
            const double above = sample(column, row);
            surface = above + (sample(column, row + 1) - above) * (v - row);
        } else if (now == rows.next) {
            const int row = rows.cross(), column = whole_below(u);
            const double left = sample(column, row);
            surface = left + (sample(column + 1, row) - left) * (u - column);
        } else {
            const int row = whole_below(v), column = row + diagonals.cross();
            const double first = sample(column, row);
            surface = first + (sample(column + 1, row + 1) - first) * (v - row);
        }
        const double gap = (end ? finger.w : w) - surface;
        const bool hit = gap < 0, tired = --steps <= 0;
        if (!hit && end) {
            place_ = finger;
            facet_ = facet_at(finger.u, finger.v);
            return true;
        }
        if (hit || tired) {
            const double middle = (before + now) / 2,
                         at = hit ? before + (now - before) * (gap_before / (gap_before - gap)) : now;
            facet_ = facet_at(from.u + du * middle, from.v + dv * middle);
            place_ = {from.u + du * at, from.v + dv * at, from.w + dw * at};
            return false;
        }
        before = now;
        gap_before = gap;
    }
}

bool Proxy::nearer(const Facet& facet, const Place& finger, Foot& best) noexcept {
    const Foot foot = nearest(facet, finger);
    if (foot.squared >= best.squared) return false;
    best = foot;
    facet_ = facet;
    return true;
}

// Whether the way from the proxy to a corner of a facet that it lies on begins towards the finger. Where none does, no way
// between them does either, and the facets need not be asked.
bool Proxy::leads_down(const Place& finger, int column, int row) const noexcept {
    return (finger.u - place_.u) * (column - place_.u) + (finger.v - place_.v) * (row - place_.v) +
               (finger.w - place_.w) * (sample(column, row) - place_.w) >
           0;
}

bool Proxy::nearer_around(int column, int row, const Place& finger, Foot& best, int& steps) noexcept {
    // Corners and facets in turn: facet k lies between corners k and k + 1.
    static constexpr std::array<std::array<int, 2>, 6> kCorners = {{{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}}};
    static constexpr std::array<Facet, 6> kFacets = {
        {{0, 0, false}, {0, 0, true}, {-1, 0, false}, {-1, -1, true}, {-1, -1, false}, {0, -1, true}}};
    const bool all = best.in_air || column <= 0 || row <= 0 || column >= last_column_ || row >= last_row_;
    std::array<bool, 7> down{};
    for (std::size_t k = 0; k < 6; ++k) down[k] = all || leads_down(finger, column + kCorners[k][0], row + kCorners[k][1]);
    down[6] = down[0];
    bool moved = false;
    for (std::size_t k = 0; k < 6; ++k) {
        if (!down[k] && !down[k + 1]) continue;
        moved = nearer({column + kFacets[k].column, row + kFacets[k].row, kFacets[k].lower}, finger, best) || moved;
        --steps;
    }
    return moved;
}

// Down the distance from column to column. Gives false where it comes into the air, from where the way may be straight, and when
// it has no steps left.
bool Proxy::settle(const Place& finger, int& steps) noexcept {
    Foot foot = nearest(facet_, finger);
    for (bool moved = true; moved; moved = moved && steps > 0) {
        place_ = foot.place;
        within_ = foot.border == Border::none;
        if (within_) return true;
        --steps;
        if (foot.border == Border::corner)
            moved = nearer_around(foot.beside.column, foot.beside.row, finger, foot, steps);
        else
            moved = (foot.in_air || !on_map(facet_) || !on_map(foot.beside) || leads_down(finger, foot.column, foot.row)) &&
                    nearer(foot.beside, finger, foot);
        if (moved && foot.in_air) {
            place_ = foot.place;
            within_ = false;
            return foot.squared <= 0;
        }
    }
    return steps > 0;
}

Point3 Proxy::follow(Point3 finger) noexcept {
    if (!std::isfinite(finger.x) || !std::isfinite(finger.y) || !std::isfinite(finger.z)) return last_;
    const auto goal_along = [&](double at, int last) { return std::clamp(at * per_mm_ - 0.5, -kFar, last + kFar); };
    const Place goal{goal_along(finger.x, last_column_), goal_along(finger.y, last_row_),
                     std::clamp(finger.z * per_mm_, lowest_ - kFar, highest_ + kFar)};
    settled_ = true;
    if (lifted_ || (place_.w >= highest_ && goal.w >= highest_)) {
        facet_ = facet_at(goal.u, goal.v);
        place_ = {goal.u, goal.v, std::max(goal.w, height_in(facet_, goal.u, goal.v))};
        lifted_ = within_ = false;
    }
    int steps = kMostSteps;
    // Into a facet that it lies on there is no straight way.
    bool straight = !within_ || goal.w >= height_in(facet_, goal.u, goal.v);
    for (;;) {
        if (straight && march(goal, steps)) {
            within_ = false;
            break;
        }
        if (steps > 0 && settle(goal, steps)) break;
        straight = true;
        if (steps > 0) continue;
        settled_ = false;
        break;
    }
    last_ = {std::abs(place_.u - goal.u) <= kSame ? finger.x : (place_.u + 0.5) * pitch_,
             std::abs(place_.v - goal.v) <= kSame ? finger.y : (place_.v + 0.5) * pitch_,
             std::abs(place_.w - goal.w) <= kSame ? finger.z : place_.w * pitch_};
    last_.z = std::max(last_.z, height({last_.x, last_.y}));
    return last_;
}

}  // namespace tactics
