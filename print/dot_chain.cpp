// SPDX-License-Identifier: Apache-2.0
// How: the paper is divided into boxes, one a dot, by the middles between dots; a box is what its dot is nearest to (in
// each direction). The line runs through a sequence of boxes that touch side by side. All their dots would feel like a
// staircase, so the shortest way from the first to the last is taken that may step across a corner from one box to the
// next but one, leaving out the elbow between them. Where there is a choice, the way that leaves out least of the line.
#include "print/dot_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>

namespace tactics {

namespace {

// The boxes along one direction.
class Axis {
public:
    explicit Axis(const std::vector<double>& centres) : centres_(centres) {
        if (centres.size() < 2) throw std::logic_error("a grid of dots needs two columns and two rows");
        double widest = 0;
        for (std::size_t i = 1; i < centres.size(); ++i) {
            if (!(centres[i] > centres[i - 1])) throw std::logic_error("the dots of a grid must be in ascending order");
            widest = std::max(widest, centres[i] - centres[i - 1]);
        }
        // The outer boxes reach a whole pitch out: a line just beyond the last dots is felt there rather than lost.
        edges_.push_back(centres.front() - widest);
        for (std::size_t i = 1; i < centres.size(); ++i) edges_.push_back((centres[i - 1] + centres[i]) / 2);
        edges_.push_back(centres.back() + widest);
    }
    /// -1 ... number of dots; the first and the last mean outside.
    int box(double at) const { return static_cast<int>(std::upper_bound(edges_.begin(), edges_.end(), at) - edges_.begin()) - 1; }
    /// The border between box `index - 1` and box `index`.
    double edge(int index) const { return edges_[static_cast<std::size_t>(index)]; }
    /// The distance of the dots on both sides of that border.
    double gap(int index) const {
        if (index <= 0 || index >= static_cast<int>(centres_.size())) return 0;
        return centres_[static_cast<std::size_t>(index)] - centres_[static_cast<std::size_t>(index) - 1];
    }
    /// The distance of `at` from the dot of a box, in the pitch of that side.
    double offset(double at, int index) const {
        const int inside = std::clamp(index, 0, static_cast<int>(centres_.size()) - 1);
        const double distance = at - centres_[static_cast<std::size_t>(inside)];
        const double pitch = gap(distance < 0 ? inside : inside + 1);
        return distance / (pitch > 0 ? pitch : edges_.back() - centres_.back());
    }

private:
    const std::vector<double>& centres_;
    std::vector<double> edges_;
};

// From time `from` on the line is in box `box` of an axis. Time is the number of a point, with fractions between points.
struct Stay {
    double from = 0;
    int box = 0;
    double low = 0;  // the range of the coordinate until the next stay
    double high = 0;
};

// An open line that begins or ends just across a border would get a hook there, up to 5 mm to the side.
void trim_ends(std::vector<Stay>& stays, const Axis& axis) {
    const auto hook = [&](const Stay& end, const Stay& next) {
        const int border = std::max(end.box, next.box);
        return (end.box > next.box ? end.high - axis.edge(border) : axis.edge(border) - end.low) < kWaver * axis.gap(border);
    };
    if (stays.size() > 1 && hook(stays.back(), stays[stays.size() - 2])) stays.pop_back();
    if (stays.size() > 1 && hook(stays[0], stays[1])) {
        stays[1].from = 0;
        stays.erase(stays.begin());
    }
}

// The boxes of one axis that the line runs through, without the wavers.
std::vector<Stay> stays(std::span<const Point> points, double Point::*coordinate, const Axis& axis, bool closed) {
    const double first = points[0].*coordinate;
    std::vector<Stay> found{{0, axis.box(first), first, first}};
    int box = found.back().box;
    const auto widen = [&](double at) {
        found.back().low = std::min(found.back().low, at);
        found.back().high = std::max(found.back().high, at);
    };
    const auto cross = [&](double time, double border, double gap, int to) {
        widen(border);
        if (found.size() > 1 && found[found.size() - 2].box == to) {
            const Stay last = found.back();
            if ((last.box > to ? last.high - border : border - last.low) < kWaver * gap) {
                found.pop_back();
                widen(last.low);
                widen(last.high);
                return;
            }
        }
        found.push_back({time, to, border, border});
    };
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double start = points[i - 1].*coordinate;
        const double end = points[i].*coordinate;
        const int target = axis.box(end);
        while (box != target) {
            const int border = target > box ? box + 1 : box;
            const double share = std::clamp((axis.edge(border) - start) / (end - start), 0.0, 1.0);
            box += target > box ? 1 : -1;
            cross(static_cast<double>(i - 1) + share, axis.edge(border), axis.gap(border), box);
        }
        widen(end);
    }
    if (!closed) trim_ends(found, axis);
    return found;
}

// One box of the sequence.
struct Visit {
    double from = 0;
    GridDot dot;
    double to = 0;
    bool keep = false;  // must be in the chain
    double length = 0;  // of the line in this box
    // How far the line extends past the dot towards each corner of the box: right low, right high, left low, left high.
    double reach[4] = {-2, -2, -2, -2};
};

std::vector<Visit> merge(const std::vector<Stay>& columns, const std::vector<Stay>& rows) {
    std::vector<Visit> visits;
    std::size_t c = 0, r = 0;
    visits.push_back({0, {columns[0].box, rows[0].box}});
    while (c + 1 < columns.size() || r + 1 < rows.size()) {
        if (r + 1 == rows.size() || (c + 1 < columns.size() && columns[c + 1].from <= rows[r + 1].from))
            ++c;
        else
            ++r;
        visits.push_back({std::max(columns[c].from, rows[r].from), {columns[c].box, rows[r].box}});
    }
    return visits;
}

Point position(std::span<const Point> points, double time) {
    const auto i = std::min(static_cast<std::size_t>(time), points.size() - 2);
    const double share = time - static_cast<double>(i);
    return {points[i].x + share * (points[i + 1].x - points[i].x), points[i].y + share * (points[i + 1].y - points[i].y)};
}

void measure(std::vector<Visit>& visits, std::span<const Point> points, const Axis& columns, const Axis& rows) {
    for (std::size_t k = 0; k < visits.size(); ++k) {
        Visit& visit = visits[k];
        const double end = k + 1 < visits.size() ? visits[k + 1].from : static_cast<double>(points.size() - 1);
        visit.to = end;
        Point before = position(points, visit.from);
        const auto note = [&](Point at) {
            visit.length += std::hypot(at.x - before.x, at.y - before.y);
            before = at;
            const double x = columns.offset(at.x, visit.dot.column), y = rows.offset(at.y, visit.dot.row);
            const double reach[4] = {x + y, x - y, y - x, -x - y};
            for (int i = 0; i < 4; ++i) visit.reach[i] = std::max(visit.reach[i], reach[i]);
        };
        note(before);
        for (auto i = static_cast<std::size_t>(visit.from) + 1; static_cast<double>(i) < end; ++i) note(points[i]);
        note(position(points, end));
    }
}

double squared(Point a, Point b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); }

// The points where the line turns sharply, judged by where it was and will be a length of `reach` away; the sharpest of
// those that follow each other closer than that.
std::vector<std::size_t> sharp_turns(std::span<const Point> points, double reach) {
    const double least = std::cos(kSharpTurn * std::numbers::pi / 180);
    std::vector<double> along(points.size(), 0);
    for (std::size_t i = 1; i < points.size(); ++i) along[i] = along[i - 1] + std::sqrt(squared(points[i], points[i - 1]));
    const auto at = [&](std::size_t segment, double where) {
        const double length = along[segment + 1] - along[segment];
        return position(
            points, static_cast<double>(segment) + (length > 0 ? std::clamp((where - along[segment]) / length, 0.0, 1.0) : 0));
    };
    std::vector<std::size_t> turns;
    double sharpest = 2;
    std::size_t back = 0, ahead = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        while (along[back + 1] < along[i] - reach) ++back;
        while (ahead + 2 < points.size() && along[ahead + 1] < along[i] + reach) ++ahead;
        const Point from = at(back, along[i] - reach), to = at(ahead, along[i] + reach);
        const double size = std::sqrt(squared(from, points[i]) * squared(to, points[i]));
        if (!(size > 0)) continue;
        const double cosine =
            ((points[i].x - from.x) * (to.x - points[i].x) + (points[i].y - from.y) * (to.y - points[i].y)) / size;
        if (cosine > least) continue;
        if (!turns.empty() && along[i] - along[turns.back()] < reach) {
            if (cosine < sharpest) {
                turns.back() = i;
                sharpest = cosine;
            }
        } else {
            turns.push_back(i);
            sharpest = cosine;
        }
    }
    return turns;
}

// Whether the chain may go from `a` straight to `c` without the elbow `b`. Not if the line passes behind the dot of the elbow: it
// would then lie more than a pitch from the remaining dots.
bool may_leave_out(const Visit& a, const Visit& b, const Visit& c) {
    const int across = c.dot.column - a.dot.column, down = c.dot.row - a.dot.row;
    if (b.keep || std::abs(across) != 1 || std::abs(down) != 1) return false;
    // Outwards from the corner that the three boxes share to the elbow's dot.
    const int x = b.dot.column - a.dot.column + b.dot.column - c.dot.column;
    const int y = b.dot.row - a.dot.row + b.dot.row - c.dot.row;
    // A straight line never passes the dot on the outer side of an even grid; an uneven one bends it a little.
    constexpr double kBend = 0.2;
    return b.reach[x > 0 ? (y > 0 ? 0 : 1) : (y > 0 ? 2 : 3)] <= kBend;
}

// Which visits make the way.
std::vector<std::size_t> shortest_way(const std::vector<Visit>& visits) {
    struct Cost {
        std::size_t dots = 0;
        double left_out = 0;
        std::size_t before = 0;
    };
    std::vector<Cost> best(visits.size());
    for (std::size_t k = 1; k < visits.size(); ++k) {
        best[k] = {best[k - 1].dots + 1, best[k - 1].left_out, k - 1};
        if (k < 2 || !may_leave_out(visits[k - 2], visits[k - 1], visits[k])) continue;
        const Cost across{best[k - 2].dots + 1, best[k - 2].left_out + visits[k - 1].length, k - 2};
        if (std::tie(across.dots, across.left_out) < std::tie(best[k].dots, best[k].left_out)) best[k] = across;
    }
    std::vector<std::size_t> way{visits.size() - 1};
    while (way.back() > 0) way.push_back(best[way.back()].before);
    std::reverse(way.begin(), way.end());
    return way;
}

double smallest_pitch(const DotGrid& grid) {
    double pitch = grid.columns[1] - grid.columns[0];
    for (std::size_t i = 1; i < grid.columns.size(); ++i) pitch = std::min(pitch, grid.columns[i] - grid.columns[i - 1]);
    for (std::size_t i = 1; i < grid.rows.size(); ++i) pitch = std::min(pitch, grid.rows[i] - grid.rows[i - 1]);
    return pitch;
}

// The visits that make the chain of a line with two ends.
std::vector<Visit> chain_of(std::span<const Point> points, bool closed, const DotGrid& grid, const Axis& columns,
                            const Axis& rows) {
    std::vector<Visit> visits = merge(stays(points, &Point::x, columns, closed), stays(points, &Point::y, rows, closed));
    measure(visits, points, columns, rows);
    visits.front().keep = visits.back().keep = true;
    for (const std::size_t turn : sharp_turns(points, smallest_pitch(grid))) {
        const auto after = std::upper_bound(visits.begin(), visits.end(), static_cast<double>(turn),
                                            [](double time, const Visit& visit) { return time < visit.from; });
        std::prev(after)->keep = true;
    }
    std::vector<Visit> chain;
    for (const std::size_t k : shortest_way(visits)) chain.push_back(visits[k]);
    return chain;
}

// A closed line, cut open at a new point between two of its points.
std::vector<Point> cut_at(std::span<const Point> ring, double time) {
    const auto before = std::min(static_cast<std::size_t>(time), ring.size() - 1);
    const auto after = static_cast<std::ptrdiff_t>(before) + 1;
    const Point cut = position(std::array{ring[before], ring[(before + 1) % ring.size()]}, time - static_cast<double>(before));
    std::vector<Point> open{cut};
    open.insert(open.end(), ring.begin() + after, ring.end());
    open.insert(open.end(), ring.begin(), ring.begin() + after);
    open.push_back(cut);
    return open;
}

}  // namespace

std::vector<GridDot> dot_chain(std::span<const Point> points, bool closed, const DotGrid& grid) {
    if (points.empty()) return {};
    for (const Point& point : points)
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) throw std::logic_error("a point of a page is not finite");
    const Axis columns(grid.columns), rows(grid.rows);
    if (points.size() == 1) return {{columns.box(points[0].x), rows.box(points[0].y)}};

    std::vector<Visit> chain;
    if (closed) {
        // The dot where a line is cut is always kept, even if unneeded. So the line is first cut anywhere, and then finally half
        // way round, at a dot that the first chain kept although it could have left it out.
        std::vector<Point> ring(points.begin(), points.end());
        ring.push_back(points[0]);
        chain = chain_of(ring, true, grid, columns, rows);
        ring.pop_back();
        const Visit& middle = chain[chain.size() / 2];
        chain = chain_of(cut_at(ring, (middle.from + middle.to) / 2), true, grid, columns, rows);
    } else {
        chain = chain_of(points, false, grid, columns, rows);
    }
    std::vector<GridDot> dots;
    for (const Visit& visit : chain) dots.push_back(visit.dot);
    return dots;
}

}  // namespace tactics
