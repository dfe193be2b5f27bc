// SPDX-License-Identifier: Apache-2.0
#include "filters/smooth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/geometry/walk.h"

namespace tactics {

namespace {

// Each point is moved onto a parabola fitted to its neighbours along the line by least squares, with as many neighbours as
// a parabola can follow: local regression with a window that grows until it no longer fits (the idea of O. Lepski's and
// A. Goldenshluger's adaptive estimators). A window of 2h+1 points leaves about 1/sqrt(2h+1) of the pixel grid's error.
constexpr int kWidest = 24;
// Rounding to a grid has a standard deviation of 0.29 pixels; twice-averaged it is less. Beyond this it is no longer the grid.
constexpr double kFits = 0.30;
// A straight line replaces the parabola, which is less sure, as long as this shifts the point by less than a tenth of a
// pixel; in between the two are mixed, so that nothing jumps.
constexpr double kStraightBow = 0.05, kCurvedBow = 0.15;

// Coordinates are far from overflow, and the square root is many times faster than std::hypot.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

// For windows of n = 2h + 1 points -h..h: 1/n, sum k^2 / n, 1 / sum k^2, and 1 / (sum k^4 - (sum k^2)^2 / n).
struct Moments {
    std::array<double, kWidest + 1> count{}, lift{}, second{}, spread{};
};
constexpr Moments make_moments() {
    Moments m;
    double second = 0, fourth = 0;
    for (std::size_t h = 1; h <= kWidest; ++h) {
        const auto k = static_cast<double>(h);
        second += 2 * k * k;
        fourth += 2 * k * k * k * k;
        m.count[h] = 1 / (2 * k + 1);
        m.lift[h] = second / (2 * k + 1);
        m.second[h] = 1 / second;
        m.spread[h] = h > 1 ? 1 / (fourth - second * second / (2 * k + 1)) : 0;  // three points: no bend is measured
    }
    return m;
}
constexpr Moments kMoments = make_moments();

// The parabola level + slope k + bend k^2, k in steps from the middle of its window.
struct Fit {
    Point level{}, slope{}, bend{};
    Point at(double k) const { return {level.x + k * (slope.x + k * bend.x), level.y + k * (slope.y + k * bend.y)}; }
};

// Sums over a window that grows by one point on either side.
struct Window {
    Point even{}, square{}, odd{};  // sum p, sum k^2 p, sum k p, all from the middle point
    double power = 0;               // sum |p|^2
    int h = 0;

    void grow(Point before, Point after, Point middle) {
        ++h;
        const double k = h;
        const Point a{after.x - middle.x, after.y - middle.y}, b{before.x - middle.x, before.y - middle.y};
        const Point sum{a.x + b.x, a.y + b.y};
        even = {even.x + sum.x, even.y + sum.y};
        square = {square.x + k * k * sum.x, square.y + k * k * sum.y};
        odd = {odd.x + k * (a.x - b.x), odd.y + k * (a.y - b.y)};
        power += a.x * a.x + a.y * a.y + b.x * b.x + b.y * b.y;
    }
    // Mean square distance from the straight line, and from the parabola.
    double straight_misfit() const {
        const auto i = static_cast<std::size_t>(h);
        return (power - (even.x * even.x + even.y * even.y) * kMoments.count[i] -
                (odd.x * odd.x + odd.y * odd.y) * kMoments.second[i]) *
               kMoments.count[i];
    }
    double misfit() const {
        const auto i = static_cast<std::size_t>(h);
        const double cx = square.x - kMoments.lift[i] * even.x, cy = square.y - kMoments.lift[i] * even.y;
        return straight_misfit() - (cx * cx + cy * cy) * kMoments.spread[i] * kMoments.count[i];
    }
    Fit fit(Point middle) const {
        if (h == 0) return {middle, {}, {}};
        const auto i = static_cast<std::size_t>(h);
        const double lift = kMoments.lift[i];
        Fit fit;
        fit.bend = {(square.x - lift * even.x) * kMoments.spread[i], (square.y - lift * even.y) * kMoments.spread[i]};
        const double shift = length(fit.bend.x, fit.bend.y) * lift;  // of the straight line against the parabola
        const double keep = std::clamp((shift - kStraightBow) / (kCurvedBow - kStraightBow), 0.0, 1.0);
        fit.bend = {keep * fit.bend.x, keep * fit.bend.y};
        fit.level = {middle.x + even.x * kMoments.count[i] - fit.bend.x * lift,
                     middle.y + even.y * kMoments.count[i] - fit.bend.y * lift};
        fit.slope = {odd.x * kMoments.second[i], odd.y * kMoments.second[i]};
        return fit;
    }
};

// Averages neighbours (1 2 1): takes off the worst of the steps before lengths along the line are measured.
std::vector<Point> averaged(const std::vector<Point>& points, bool closed) {
    std::vector<Point> result = points;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!closed && (i == 0 || i + 1 == n)) continue;
        const Point a = points[i == 0 ? n - 1 : i - 1], b = points[i], c = points[i + 1 == n ? 0 : i + 1];
        result[i] = {(a.x + 2 * b.x + c.x) / 4, (a.y + 2 * b.y + c.y) / 4};
    }
    return result;
}

// The same line with points at even steps of about one pixel.
std::vector<Point> even_steps(std::vector<Point> points, bool closed) {
    if (closed) points.push_back(points.front());
    double total = 0;
    for (std::size_t i = 1; i < points.size(); ++i) total += distance(points[i - 1], points[i]);
    const auto steps = static_cast<std::size_t>(std::max(closed ? 3.0 : 1.0, std::round(total)));
    const double step = total / static_cast<double>(steps);
    std::vector<Point> result;
    result.reserve(steps + 1);
    Walk walk(points, false);
    for (std::size_t s = 0; s < steps; ++s) result.push_back(walk.to(step * static_cast<double>(s)));
    if (!closed) result.push_back(points.back());
    return result;
}

// The widest window around `middle`, at most `limit` to each side, that a parabola still follows.
template <typename At>
Fit fit_around(At at, std::ptrdiff_t middle, int least, int limit) {
    const Point centre = at(middle);
    Window window, best;
    while (window.h < std::min(least, limit)) window.grow(at(middle - window.h - 1), at(middle + window.h + 1), centre);
    best = window;
    while (window.h < limit) {
        window.grow(at(middle - window.h - 1), at(middle + window.h + 1), centre);
        if (window.h > 8 && window.h % 2 != 0) continue;  // wide windows are looked at every other time
        if (window.misfit() > kFits * kFits) break;
        best = window;
    }
    return best.fit(centre);
}

// The window at an end of the line: it grows inwards only, and is used for all points up to its middle.
template <typename At>
std::pair<Fit, int> fit_end(At at, int least, int limit) {
    Window best;
    for (int h = 1; h <= limit; ++h) {
        Window window;
        for (int k = 1; k <= h; ++k) window.grow(at(h - k), at(h + k), at(h));
        if (h > least && window.misfit() > kFits * kFits) break;
        best = window;
    }
    return {best.fit(at(best.h)), best.h};
}

constexpr int kLeastWindow = 3;  // smaller windows leave the steps in

// A corner is where two straight sides of seven points fit well and the parabola through both does not, and where they turn
// by 40 degrees or more, but not back by more than 170. The line passes as near to the point in which the sides would meet
// as an arc of two pixels' radius does, and half a pixel for the grid: anything rounder is an arc.
constexpr int kSide = 7;
constexpr double kSideFits = 0.3;
constexpr double kTurn = 0.766, kBack = 0.985;  // cos 40, cos 10 degrees
constexpr double kRounded = 2, kGrid = 0.5, kFarthestCorner = 3;

struct Side {
    Point middle, direction;
    double misfit;
};

// The straight line through the samples 1 to kSide away from `from`, in steps of `step` (1 or -1).
template <typename At>
Side side_of(At at, std::ptrdiff_t from, std::ptrdiff_t step) {
    constexpr int kHalf = kSide / 2;
    const std::ptrdiff_t middle = from + step * (1 + kHalf);
    Window window;
    for (int k = 1; k <= kHalf; ++k) window.grow(at(middle - step * k), at(middle + step * k), at(middle));
    const double size = length(window.odd.x, window.odd.y);
    return {{at(middle).x + window.even.x / kSide, at(middle).y + window.even.y / kSide},
            size > 0 ? Point{window.odd.x / size, window.odd.y / size} : Point{},
            window.straight_misfit()};
}

struct Corner {
    std::ptrdiff_t sample;
    double turn;  // cosine; the smaller the sharper
    Point at;
};

// Where the two sides meet; far away if they hardly do.
Point meeting_of(const Side& before, const Side& after) {
    const Point u = before.direction, v = after.direction;
    const double cross = u.x * v.y - u.y * v.x;
    const double t = ((after.middle.x - before.middle.x) * v.y - (after.middle.y - before.middle.y) * v.x) / cross;
    return {before.middle.x + t * u.x, before.middle.y + t * u.y};
}

// The corners in order; of those that share a side the sharpest.
template <typename At>
std::vector<Corner> corners_of(At at, std::ptrdiff_t begin, std::ptrdiff_t end) {
    std::vector<Corner> corners;
    for (std::ptrdiff_t i = begin; i < end; ++i) {
        // Quick look first: where the line hardly turns there is no corner.
        const Point a = at(i - kSide), b = at(i), c = at(i + kSide);
        const Point u{b.x - a.x, b.y - a.y}, v{c.x - b.x, c.y - b.y};
        const double along = u.x * v.x + u.y * v.y;
        if (along > 0 && along * along > 0.8 * (u.x * u.x + u.y * u.y) * (v.x * v.x + v.y * v.y)) continue;
        Window window;
        while (window.h <= kSide) window.grow(at(i - window.h - 1), at(i + window.h + 1), b);
        if (window.misfit() <= kFits * kFits) continue;
        const Side before = side_of(at, i, -1), after = side_of(at, i, 1);
        if (std::max(before.misfit, after.misfit) > kSideFits * kSideFits) continue;
        const double turn = -(before.direction.x * after.direction.x + before.direction.y * after.direction.y);
        if (turn > kTurn || turn < -kBack) continue;
        const Point meeting = meeting_of(before, after);
        const double arc = kRounded * (1 / std::sqrt((1 + turn) / 2) - 1);
        if (distance(meeting, b) > std::min(arc + kGrid, kFarthestCorner)) continue;
        if (!corners.empty() && i - corners.back().sample < kSide) {
            if (turn >= corners.back().turn) continue;
            corners.pop_back();
        }
        corners.push_back({i, turn, meeting});
    }
    return corners;
}

std::vector<Point> smooth_loop(const std::vector<Point>& p) {
    const auto n = static_cast<std::ptrdiff_t>(p.size());
    const int limit = static_cast<int>(std::min<std::ptrdiff_t>(kWidest, n / 6));
    const auto at = [&](std::ptrdiff_t i) { return p[static_cast<std::size_t>(i < 0 ? i + n : i >= n ? i - n : i)]; };
    std::vector<Point> result;
    const std::ptrdiff_t stride = n >= 16 ? 2 : 1;
    for (std::ptrdiff_t i = 0; i + stride <= n; i += stride)
        result.push_back(fit_around(at, i, std::min(kLeastWindow, limit), limit).level);
    return result;
}

// Adds the samples `first` to `last` of a line, smoothed, without the last one.
void smooth_piece(const std::vector<Point>& p, std::ptrdiff_t first, std::ptrdiff_t last, std::vector<Point>& result) {
    const std::ptrdiff_t n = last - first + 1;
    const int limit = static_cast<int>(std::min<std::ptrdiff_t>(kWidest, (n - 1) / 2));
    const auto forward = [&](std::ptrdiff_t i) { return p[static_cast<std::size_t>(first + i)]; };
    const auto backward = [&](std::ptrdiff_t i) { return p[static_cast<std::size_t>(last - i)]; };
    const auto [head, head_h] = fit_end(forward, kLeastWindow, limit);
    const auto [tail, tail_h] = fit_end(backward, kLeastWindow, limit);
    for (std::ptrdiff_t i = 0; i + 1 < n; i += 2) {
        const std::ptrdiff_t left = n - 1 - i;
        if (i < head_h && i <= left)
            result.push_back(head.at(static_cast<double>(i - head_h)));
        else if (left < tail_h)
            result.push_back(tail.at(static_cast<double>(left - tail_h)));
        else
            result.push_back(
                fit_around(forward, i, kLeastWindow, static_cast<int>(std::min<std::ptrdiff_t>({limit, i, left}))).level);
    }
}

// The last point of a line that has no corner: where the fit at its end puts it.
Point smooth_end(const std::vector<Point>& p, std::ptrdiff_t first) {
    const auto last = static_cast<std::ptrdiff_t>(p.size()) - 1;
    const int limit = static_cast<int>(std::min<std::ptrdiff_t>(kWidest, (last - first) / 2));
    const auto [tail, h] = fit_end([&](std::ptrdiff_t i) { return p[static_cast<std::size_t>(last - i)]; }, kLeastWindow, limit);
    return tail.at(-h);
}

std::vector<Point> smooth_line(std::vector<Point> p, const std::vector<Corner>& corners) {
    std::vector<Point> result;
    std::ptrdiff_t first = 0;
    for (const Corner& corner : corners) {
        p[static_cast<std::size_t>(corner.sample)] = corner.at;
        const std::size_t start = result.size();
        smooth_piece(p, first, corner.sample, result);
        if (first > 0) result[start] = p[static_cast<std::size_t>(first)];
        first = corner.sample;
    }
    const std::size_t start = result.size();
    smooth_piece(p, first, static_cast<std::ptrdiff_t>(p.size()) - 1, result);
    if (first > 0) result[start] = p[static_cast<std::size_t>(first)];
    result.push_back(smooth_end(p, first));
    return result;
}

// A loop with corners is a line from one corner round to the same.
std::vector<Point> smooth_cornered_loop(std::vector<Point> p, std::vector<Corner> corners) {
    const std::ptrdiff_t first = corners.front().sample;
    const Point start = corners.front().at;
    std::rotate(p.begin(), p.begin() + first, p.end());
    p.front() = start;
    p.push_back(start);
    corners.erase(corners.begin());
    for (Corner& corner : corners) corner.sample -= first;
    auto result = smooth_line(std::move(p), corners);
    result.front() = start;
    result.pop_back();
    return result;
}

}  // namespace

std::vector<Point> smooth(const std::vector<Point>& points, bool closed) {
    if (points.size() < (closed ? 3u : 2u)) return points;
    auto even = even_steps(averaged(points, closed), closed);
    const auto n = static_cast<std::ptrdiff_t>(even.size());
    if (n < (closed ? 6 : 3)) return even;
    if (!closed) {
        const auto at = [&](std::ptrdiff_t i) { return even[static_cast<std::size_t>(i)]; };
        const auto corners = corners_of(at, kSide + 1, n - kSide - 1);
        return smooth_line(std::move(even), corners);
    }
    if (n < 3 * kSide) return smooth_loop(even);
    const auto at = [&](std::ptrdiff_t i) { return even[static_cast<std::size_t>(i < 0 ? i + n : i >= n ? i - n : i)]; };
    auto corners = corners_of(at, 0, n);
    // The last and the first may share a side.
    if (corners.size() > 1 && corners.front().sample + n - corners.back().sample < kSide) {
        if (corners.front().turn <= corners.back().turn)
            corners.pop_back();
        else
            corners.erase(corners.begin());
    }
    return corners.empty() ? smooth_loop(even) : smooth_cornered_loop(std::move(even), std::move(corners));
}

}  // namespace tactics
