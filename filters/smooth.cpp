#include "filters/smooth.h"

#include <algorithm>
#include <array>
#include <cmath>

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
constexpr double kStraight = 0.05, kCurved = 0.15;

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

struct Moments {
    std::array<double, kWidest + 1> second{}, spread{};  // sum k^2 and sum k^4 - (sum k^2)^2 / n over -h..h
};
constexpr Moments make_moments() {
    Moments m;
    double second = 0, fourth = 0;
    for (std::size_t h = 1; h <= kWidest; ++h) {
        const auto k = static_cast<double>(h);
        second += 2 * k * k;
        fourth += 2 * k * k * k * k;
        m.second[h] = second;
        m.spread[h] = fourth - second * second / (2 * k + 1);
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
    // Mean square distance from the parabola.
    double misfit() const {
        const auto i = static_cast<std::size_t>(h);
        const double n = 2 * h + 1, lift = kMoments.second[i] / n;
        const double cx = square.x - lift * even.x, cy = square.y - lift * even.y;
        const double rest = power - (even.x * even.x + even.y * even.y) / n - (odd.x * odd.x + odd.y * odd.y) / kMoments.second[i] -
                            (h > 1 ? (cx * cx + cy * cy) / kMoments.spread[i] : 0);
        return rest / n;
    }
    Fit fit(Point middle) const {
        if (h == 0) return {middle, {}, {}};
        const auto i = static_cast<std::size_t>(h);
        const double n = 2 * h + 1, lift = kMoments.second[i] / n;
        Fit fit;
        if (h > 1) fit.bend = {(square.x - lift * even.x) / kMoments.spread[i], (square.y - lift * even.y) / kMoments.spread[i]};
        const double shift = std::hypot(fit.bend.x, fit.bend.y) * lift;  // of the straight line against the parabola
        const double keep = std::clamp((shift - kStraight) / (kCurved - kStraight), 0.0, 1.0);
        fit.bend = {keep * fit.bend.x, keep * fit.bend.y};
        fit.level = {middle.x + even.x / n - fit.bend.x * lift, middle.y + even.y / n - fit.bend.y * lift};
        fit.slope = {odd.x / kMoments.second[i], odd.y / kMoments.second[i]};
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
    double passed = 0;
    std::size_t i = 1;
    for (std::size_t s = 0; s < steps; ++s) {
        const double wanted = step * static_cast<double>(s);
        double side = distance(points[i - 1], points[i]);
        while (passed + side < wanted && i + 1 < points.size()) {
            passed += side;
            ++i;
            side = distance(points[i - 1], points[i]);
        }
        const double t = side > 0 ? std::clamp((wanted - passed) / side, 0.0, 1.0) : 0;
        const Point a = points[i - 1], b = points[i];
        result.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    if (!closed) result.push_back(points.back());
    return result;
}

// The widest window around `middle`, at most `limit` to each side, that a parabola still follows.
template <typename At>
Fit fit_around(At at, std::ptrdiff_t middle, int least, int limit) {
    const Point centre = at(middle);
    Window window, best;
    while (window.h < limit) {
        window.grow(at(middle - window.h - 1), at(middle + window.h + 1), centre);
        if (window.h > least && window.misfit() > kFits * kFits) break;
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

constexpr int kLeast = 3;  // smaller windows leave the steps in

std::vector<Point> smooth_loop(const std::vector<Point>& p) {
    const auto n = static_cast<std::ptrdiff_t>(p.size());
    const int limit = static_cast<int>(std::min<std::ptrdiff_t>(kWidest, n / 6));
    const auto at = [&](std::ptrdiff_t i) { return p[static_cast<std::size_t>(i < 0 ? i + n : i >= n ? i - n : i)]; };
    std::vector<Point> result;
    const std::ptrdiff_t stride = n >= 16 ? 2 : 1;
    for (std::ptrdiff_t i = 0; i + stride <= n; i += stride) result.push_back(fit_around(at, i, std::min(kLeast, limit), limit).level);
    return result;
}

std::vector<Point> smooth_line(const std::vector<Point>& p) {
    const auto n = static_cast<std::ptrdiff_t>(p.size());
    const int limit = static_cast<int>(std::min<std::ptrdiff_t>(kWidest, (n - 1) / 2));
    const auto forward = [&](std::ptrdiff_t i) { return p[static_cast<std::size_t>(i)]; };
    const auto backward = [&](std::ptrdiff_t i) { return p[static_cast<std::size_t>(n - 1 - i)]; };
    const auto [head, head_h] = fit_end(forward, kLeast, limit);
    const auto [tail, tail_h] = fit_end(backward, kLeast, limit);
    std::vector<Point> result;
    for (std::ptrdiff_t i = 0; i < n;) {
        const std::ptrdiff_t left = n - 1 - i;
        if (i < head_h && i <= left)
            result.push_back(head.at(static_cast<double>(i - head_h)));
        else if (left < tail_h)
            result.push_back(tail.at(static_cast<double>(left - tail_h)));
        else
            result.push_back(fit_around(forward, i, kLeast, static_cast<int>(std::min<std::ptrdiff_t>({limit, i, left}))).level);
        if (i + 1 == n) break;
        i = std::min(i + 2, n - 1);
    }
    return result;
}

}  // namespace

std::vector<Point> smooth(const std::vector<Point>& points, bool closed) {
    if (points.size() < (closed ? 3u : 2u)) return points;
    const auto even = even_steps(averaged(points, closed), closed);
    if (even.size() < (closed ? 6u : 3u)) return even;
    return closed ? smooth_loop(even) : smooth_line(even);
}

}  // namespace tactics
