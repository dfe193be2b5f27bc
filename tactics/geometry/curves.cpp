// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "tactics/geometry/course.h"
#include "tactics/geometry/vectors.h"

namespace tactics {

namespace {

// A line turns at a corner by more than this within the length of two arms. Own choices: rounder than this is drawn as a bend.
constexpr double kCorner = 40 * std::numbers::pi / 180;
constexpr double kArm = 1.2;     // mm
constexpr double kStep = 0.4;    // mm between places at which the curve is held against the line
constexpr int kRounds = 4;       // of placing the points along the curve anew (Schneider: 4)
constexpr int kMostSplits = 40;  // of a stretch within a stretch; what is not done then stays straight

Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator*(double s, Point p) { return {s * p.x, s * p.y}; }
Point unit(Point p) {
    const double length = std::hypot(p.x, p.y);
    return length > 0 ? Point{p.x / length, p.y / length} : Point{1, 0};
}

struct Cubic {
    Point a, b, c, d;
    Point at(double t) const {
        const double s = 1 - t;
        return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
    }
    Point slope(double t) const {
        const double s = 1 - t;
        return 3 * s * s * (b - a) + 6 * s * t * (c - b) + 3 * t * t * (d - c);
    }
    Point bend(double t) const { return 6 * (1 - t) * (c - 2.0 * b + a) + 6 * t * (d - 2.0 * c + b); }
};

// The points of the line, and more between those that are far apart. `own` says where the line's own are.
std::vector<Point> closely(const std::vector<Point>& points, std::vector<std::size_t>& own) {
    std::vector<Point> out{points.front()};
    own.push_back(0);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Point from = points[i - 1], to = points[i];
        const double count = std::min(1000.0, std::ceil(distance(from, to) / kStep));
        for (double k = 1; k < count; ++k) out.push_back(from + (k / count) * (to - from));
        out.push_back(to);
        own.push_back(out.size() - 1);
    }
    return out;
}

// The way from a point to where the line is an arm's length before it or behind it.
Point arm(const std::vector<Point>& line, std::size_t from, bool back, bool closed) {
    const std::size_t count = line.size();
    double left = kArm;
    std::size_t at = from;
    for (std::size_t steps = 0; steps < count && left > 0; ++steps) {
        const std::size_t end = back ? 0 : count - 1;
        if (at == end) {
            if (!closed) break;
            at = back ? count - 1 : 0;  // which are the same place
        }
        const std::size_t next = back ? at - 1 : at + 1;
        left -= distance(line[at], line[next]);
        at = next;
    }
    return unit(line[at] - line[from]);
}

double turn_at(const std::vector<Point>& line, std::size_t i, bool closed) {
    const Point before = arm(line, i, true, closed), behind = arm(line, i, false, closed);
    return std::acos(std::clamp(-dot(before, behind), -1.0, 1.0));
}

// Where the line turns sharply, the sharpest place of each bend; its ends always.
std::vector<std::size_t> corners_of(const std::vector<Point>& line, const std::vector<std::size_t>& own, bool closed) {
    std::vector<double> turns(own.size(), 0);
    for (std::size_t k = 1; k + 1 < own.size(); ++k) turns[k] = turn_at(line, own[k], closed);
    std::vector<std::size_t> corners{0};
    for (std::size_t k = 1; k + 1 < own.size(); ++k) {
        if (turns[k] < kCorner) continue;
        bool sharpest = true;
        for (std::size_t j = k; j-- > 0 && distance(line[own[j]], line[own[k]]) < kArm;)
            sharpest = sharpest && turns[j] <= turns[k];
        for (std::size_t j = k + 1; j < own.size() && distance(line[own[j]], line[own[k]]) < kArm; ++j)
            sharpest = sharpest && turns[j] < turns[k];
        if (sharpest) corners.push_back(own[k]);
    }
    corners.push_back(line.size() - 1);
    return corners;
}

class Fitting {
public:
    Fitting(const std::vector<Point>& line, double tolerance) : line_(line), tolerance_(tolerance) {}

    // From one point to another, with the ways in which the curve leaves the first and comes back out of the last.
    void fit(std::size_t from, std::size_t to, Point leaves, Point comes, int splits) {
        const std::span<const Point> points(line_.data() + from, to - from + 1);
        if (is_straight(points)) return pieces_.push_back({true, {}, {}, points.back()});
        std::vector<double> places = along(points);
        Cubic cubic = least_squares(points, places, leaves, comes);
        std::size_t worst = 0;
        for (int round = 0; round < kRounds; ++round) {
            double error = farthest(points, places, cubic, worst);
            if (error <= tolerance_) return pieces_.push_back({false, cubic.b, cubic.c, cubic.d});
            if (error > 16 * tolerance_) break;
            for (std::size_t i = 1; i + 1 < points.size(); ++i) places[i] = nearer(cubic, points[i], places[i]);
            if (!std::is_sorted(places.begin(), places.end())) break;
            cubic = least_squares(points, places, leaves, comes);
        }
        if (farthest(points, places, cubic, worst) <= tolerance_ && std::is_sorted(places.begin(), places.end()))
            return pieces_.push_back({false, cubic.b, cubic.c, cubic.d});
        if (splits == 0 || points.size() < 4) {
            for (const Point& p : points.subspan(1)) pieces_.push_back({true, {}, {}, p});
            return;
        }
        worst = std::clamp<std::size_t>(worst, 1, points.size() - 2);
        const std::size_t middle = from + worst;
        const Point way = unit(line_[std::min(middle + 1, to)] - line_[middle - 1]);
        fit(from, middle, leaves, -1.0 * way, splits - 1);
        fit(middle, to, way, comes, splits - 1);
    }

    std::vector<CurvePiece> finish() { return std::move(pieces_); }

private:
    bool is_straight(std::span<const Point> points) const {
        return std::all_of(points.begin(), points.end(),
                           [&](Point p) { return distance_to_segment(p, points.front(), points.back()) <= tolerance_ / 4; });
    }

    // Shares of its length.
    static std::vector<double> along(std::span<const Point> points) {
        std::vector<double> places{0};
        for (std::size_t i = 1; i < points.size(); ++i) places.push_back(places.back() + distance(points[i - 1], points[i]));
        const double whole = places.back();
        for (double& place : places) place = whole > 0 ? place / whole : 0;
        return places;
    }

    // Handles of such lengths that the squares of the distances are least.
    static Cubic least_squares(std::span<const Point> points, const std::vector<double>& places, Point leaves, Point comes) {
        const Point first = points.front(), last = points.back();
        double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double t = places[i], s = 1 - t;
            const Point a = (3 * s * s * t) * leaves, b = (3 * s * t * t) * comes;
            const Point rest = points[i] - ((s * s * s + 3 * s * s * t) * first + (3 * s * t * t + t * t * t) * last);
            c00 += dot(a, a);
            c01 += dot(a, b);
            c11 += dot(b, b);
            x0 += dot(a, rest);
            x1 += dot(b, rest);
        }
        const double chord = distance(first, last), whole = c00 * c11 - c01 * c01;
        double one = chord / 3, other = chord / 3;
        if (std::abs(whole) > 1e-12) {
            one = (x0 * c11 - x1 * c01) / whole;
            other = (c00 * x1 - c01 * x0) / whole;
        }
        const double least = 1e-3 * chord, most = 3 * chord;
        if (!(one > least && one < most) || !(other > least && other < most)) one = other = chord / 3;
        return {first, first + one * leaves, last + other * comes, last};
    }

    double farthest(std::span<const Point> points, const std::vector<double>& places, const Cubic& cubic,
                    std::size_t& worst) const {
        double error = 0;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            double off = distance(cubic.at(places[i]), points[i]);
            // Between two points the curve may bulge.
            const Point between = cubic.at((places[i] + places[i + 1]) / 2);
            off = std::max(off, distance_to_segment(between, points[i], points[i + 1]));
            if (off > error) {
                error = off;
                worst = i;
            }
        }
        return error;
    }

    // A step of Newton's method to the place of the curve that is nearest to the point.
    static double nearer(const Cubic& cubic, Point p, double t) {
        const Point off = cubic.at(t) - p, slope = cubic.slope(t), bend = cubic.bend(t);
        const double below = dot(slope, slope) + dot(off, bend);
        return std::abs(below) > 1e-12 ? std::clamp(t - dot(off, slope) / below, 0.0, 1.0) : t;
    }

    const std::vector<Point>& line_;
    double tolerance_;
    std::vector<CurvePiece> pieces_;
};

}  // namespace

std::vector<CurvePiece> curves_of(const std::vector<Point>& points, bool closed, double tolerance) {
    if (points.size() < 2) return {};
    std::vector<Point> whole = points;
    if (closed) whole.push_back(points.front());
    std::vector<std::size_t> own;
    const std::vector<Point> line = closely(whole, own);
    const std::vector<std::size_t> corners = corners_of(line, own, closed);
    // A closed line without a corner where it begins goes through there smoothly.
    const std::size_t last = line.size() - 1;
    const bool smooth = closed && turn_at(line, 0, true) < kCorner;
    const Point through = unit(arm(line, 0, false, true) - arm(line, last, true, true));
    Fitting fitting(line, tolerance);
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        const std::size_t from = corners[k], to = corners[k + 1];
        const Point leaves = from == 0 && smooth ? through : unit(line[std::min(from + 1, to)] - line[from]);
        const Point comes = to == last && smooth ? -1.0 * through : unit(line[to - 1] - line[to]);
        fitting.fit(from, to, leaves, comes, kMostSplits);
    }
    return fitting.finish();
}

}  // namespace tactics
