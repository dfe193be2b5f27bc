// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "tactics/geometry/box.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/walk.h"

namespace tactics {

namespace {

using std::numbers::pi;

// Two ends nearer than that feel like one: elements keep 3.2 mm apart at least (L. Hasty, Designing Tactile Graphics).
constexpr double kClosedGap = 2.0;  // mm
// A course that leaves a shape by less is that shape to a finger: about half the resolution of a fingertip of 25 dpi, and
// 1.5 % for large shapes, which are drawn by hand or traced.
constexpr double kNear = 0.8;  // mm
constexpr double kNearPart = 0.015;
// So many points tell any shape; it bounds the work on a stroke of any length.
constexpr std::size_t kMostPoints = 1000;
constexpr std::size_t kMostCorners = 200;
constexpr std::size_t kArcSteps = 64;

double angle_between(double a, double b) {
    double turn = std::fmod(b - a, 2 * pi);
    if (turn > pi) turn -= 2 * pi;
    if (turn < -pi) turn += 2 * pi;
    return turn;
}

double direction(Point from, Point to) { return std::atan2(to.y - from.y, to.x - from.x); }

std::vector<Point> thinned(std::span<const Point> points) {
    const std::size_t stride = (points.size() + kMostPoints - 1) / kMostPoints;
    std::vector<Point> out;
    for (std::size_t i = 0; i < points.size(); i += stride) out.push_back(points[i]);
    if ((points.size() - 1) % stride != 0) out.push_back(points.back());
    return out;
}

// A ring ends on its first point again.
std::vector<Point> corners_of(std::vector<Point> points, bool closed, double tolerance) {
    if (closed) points.push_back(points.front());
    std::vector<Point> corners = course_of(points, tolerance);
    if (!closed) return corners;
    corners.pop_back();
    // Where the ring begins is a corner only if the ring turns there.
    if (corners.size() > 3 && distance_to_segment(corners[0], corners.back(), corners[1]) <= tolerance)
        corners.erase(corners.begin());
    return corners;
}

// At equal steps along the course; the end of an open one is among them.
std::vector<Point> evenly(std::vector<Point> points, bool closed, double length) {
    if (closed) points.push_back(points.front());
    const double step = length / static_cast<double>(closed ? kArcSteps : kArcSteps - 1);
    std::vector<Point> out;
    Walk walk(points, false);
    for (std::size_t i = 0; i < kArcSteps; ++i) out.push_back(walk.to(static_cast<double>(i) * step));
    return out;
}

// From the right on, clockwise.
constexpr std::array<SourceWords, 8> kGapped{"circle with a gap at the right",  "circle with a gap at the lower right",
                                             "circle with a gap at the bottom", "circle with a gap at the lower left",
                                             "circle with a gap at the left",   "circle with a gap at the upper left",
                                             "circle with a gap at the top",    "circle with a gap at the upper right"};
constexpr std::array<SourceWords, 8> kOpen{
    "arc open to the right", "arc open to the lower right", "arc open to the bottom", "arc open to the lower left",
    "arc open to the left",  "arc open to the upper left",  "arc open to the top",    "arc open to the upper right"};
constexpr std::array<SourceWords, 8> kBulging{
    "arc bulging to the right", "arc bulging to the lower right", "arc bulging downwards", "arc bulging to the lower left",
    "arc bulging to the left",  "arc bulging to the upper left",  "arc bulging upwards",   "arc bulging to the upper right"};

Phrase towards(const std::array<SourceWords, 8>& names, double angle) {
    return phrase(names[static_cast<std::size_t>(std::lround(angle / (pi / 4)) + 8) % 8]);
}

// Horizontal, vertical, rising, falling.
constexpr std::array<SourceWords, 4> kStraight{"straight horizontal line", "straight vertical line",
                                               "straight line rising to the right", "straight line falling to the right"};
constexpr std::array<SourceWords, 4> kNearlyStraight{"nearly straight horizontal line", "nearly straight vertical line",
                                                     "nearly straight line rising to the right",
                                                     "nearly straight line falling to the right"};
constexpr std::array<SourceWords, 4> kSlightlyCurved{"slightly curved horizontal line", "slightly curved vertical line",
                                                     "slightly curved line rising to the right",
                                                     "slightly curved line falling to the right"};
constexpr std::array<SourceWords, 4> kWavy{"wavy horizontal line", "wavy vertical line", "wavy line rising to the right",
                                           "wavy line falling to the right"};

std::size_t heading(Point a, Point b) {
    constexpr double kLevel = 10 * pi / 180;  // a finger takes less for level
    if (a.x > b.x) std::swap(a, b);
    const double angle = direction(a, b);  // -90 to 90 degrees, y down
    if (std::abs(angle) <= kLevel) return 0;
    if (std::abs(angle) >= pi / 2 - kLevel) return 1;
    return angle < 0 ? 2 : 3;
}

constexpr SourceWords kCircle = "circle";

// A circle or an ellipse, whichever way it is turned.
std::optional<Phrase> round_name(const std::vector<Point>& even) {
    Point mean;
    for (const Point& p : even) mean = {mean.x + p.x / kArcSteps, mean.y + p.y / kArcSteps};
    double xx = 0, xy = 0, yy = 0;
    for (const Point& p : even) {
        xx += (p.x - mean.x) * (p.x - mean.x);
        xy += (p.x - mean.x) * (p.y - mean.y);
        yy += (p.y - mean.y) * (p.y - mean.y);
    }
    const double turn = 0.5 * std::atan2(2 * xy, xx - yy), c = std::cos(turn), s = std::sin(turn);
    std::vector<Point> turned;
    for (const Point& p : even) turned.push_back({c * p.x + s * p.y, c * p.y - s * p.x});
    const Rect box = rect_of(box_of(turned));
    const double a = box.width / 2, b = box.height / 2;
    if (!(a > 0 && b > 0)) return std::nullopt;
    double off = 0;
    for (const Point& p : turned) {
        const double r = std::hypot((p.x - box.left - a) / a, (p.y - box.top - b) / b);
        off += (r - 1) * (r - 1) / kArcSteps;
    }
    constexpr double kRound = 0.05;
    if (std::sqrt(off) > kRound) return std::nullopt;
    return std::min(a, b) >= 0.9 * std::max(a, b) ? phrase(kCircle) : phrase("oval");
}

// What it is called as an outline, and filled.
struct ClosedName {
    Phrase outline, area;

    ClosedName(Phrase both) : outline(both), area(std::move(both)) {}
    ClosedName(Phrase as_outline, Phrase filled) : outline(std::move(as_outline)), area(std::move(filled)) {}
};

ClosedName four_sided(const std::vector<Point>& corners) {
    bool right = true;
    double lean = 0;  // of all sides together, so that it does not matter which comes first
    for (std::size_t i = 0; i < 4; ++i) {
        const double turn =
            angle_between(direction(corners[i], corners[(i + 1) % 4]), direction(corners[(i + 1) % 4], corners[(i + 2) % 4]));
        right = right && std::abs(std::abs(turn) - pi / 2) < 12 * pi / 180;
        lean += std::remainder(direction(corners[i], corners[(i + 1) % 4]), pi / 2) / 4;
    }
    if (!right) return phrase("four-sided outline");
    const double a = distance(corners[0], corners[1]), b = distance(corners[1], corners[2]);
    const bool tilted = std::abs(lean) > 10 * pi / 180;
    if (std::min(a, b) >= 0.92 * std::max(a, b)) return tilted ? phrase("tilted square") : phrase("square");
    return tilted ? phrase("tilted rectangle") : phrase("rectangle");
}

ClosedName closed_name(const std::vector<Point>& points, const Rect& box, double length, double tolerance) {
    const std::vector<Point> corners = corners_of(points, true, tolerance);
    const std::size_t count = corners.size();
    if (count < 3) return {phrase("narrow closed outline"), phrase("narrow shape")};
    if (count == 3) return phrase("triangle");
    if (count == 4) return four_sided(corners);
    if (count <= 6) {
        const std::string number = std::to_string(count);
        return {phrase("closed outline with {0} corners", number), phrase("shape with {0} corners", number)};
    }
    if (const auto name = round_name(evenly(points, true, length))) return *name;
    // A straight course there and back is twice the diagonal of its box.
    if (length > 4 * std::hypot(box.width, box.height)) return {phrase("winding closed outline"), phrase("winding shape")};
    return {phrase("closed outline"), phrase("shape")};
}

struct OpenName {
    Phrase name;
    bool level = false;   // straight, and horizontal or vertical
    bool circle = false;  // but for a gap
};

// The circle that the points follow, by least squares (Kasa).
std::optional<OpenName> arc_name(const std::vector<Point>& even, double length, double tolerance) {
    Point mean;
    for (const Point& p : even) mean = {mean.x + p.x / kArcSteps, mean.y + p.y / kArcSteps};
    double uu = 0, uv = 0, vv = 0, ur = 0, vr = 0;
    for (const Point& p : even) {
        const double u = p.x - mean.x, v = p.y - mean.y, r = u * u + v * v;
        uu += u * u, uv += u * v, vv += v * v, ur += u * r, vr += v * r;
    }
    const double determinant = uu * vv - uv * uv;
    if (!(std::abs(determinant) > 1e-9)) return std::nullopt;
    const double u = (ur * vv - vr * uv) / determinant / 2, v = (vr * uu - ur * uv) / determinant / 2;
    const Point centre{mean.x + u, mean.y + v};
    const double radius = std::sqrt(u * u + v * v + (uu + vv) / kArcSteps);
    for (const Point& p : even)
        if (std::abs(distance(p, centre) - radius) > tolerance) return std::nullopt;
    const double sweep = length / radius;
    // Round and round, or so flat that the next drawing of the same might bulge the other way.
    if (sweep > 2 * pi || radius * (1 - std::cos(sweep / 2)) < 2 * tolerance) return std::nullopt;
    const double middle = direction(centre, even[kArcSteps / 2]);
    if (sweep > 1.75 * pi) return OpenName{towards(kGapped, middle + pi), false, true};
    return OpenName{sweep >= pi * 0.9 ? towards(kOpen, middle + pi) : towards(kBulging, middle)};
}

// Swings to and fro about a straight line.
bool is_wavy(const std::vector<Point>& even) {
    constexpr int kSwings = 4;
    Point mean;
    for (const Point& p : even) mean = {mean.x + p.x / kArcSteps, mean.y + p.y / kArcSteps};
    const double along = direction(even.front(), even.back()), c = std::cos(along), s = std::sin(along);
    std::vector<double> off;
    for (const Point& p : even) off.push_back(c * (p.y - mean.y) - s * (p.x - mean.x));
    const auto [low, high] = std::minmax_element(off.begin(), off.end());
    const double enough = (*high - *low) / 5;
    int side = 0, swings = 0;
    for (const double o : off)
        if (const int now = o > enough ? 1 : o < -enough ? -1 : 0; now != 0 && now != side) {
            swings += side != 0 ? 1 : 0;
            side = now;
        }
    return swings >= kSwings;
}

OpenName open_name(const std::vector<Point>& points, const Rect& box, double length, double tolerance) {
    const Point a = points.front(), b = points.back();
    const double chord = distance(a, b);
    const std::size_t way = heading(a, b);
    double off = 0;
    for (const Point& p : points) off = std::max(off, distance_to_segment(p, a, b));
    const bool direct = chord >= 0.95 * length;
    if (direct && off <= tolerance) return {phrase(kStraight[way]), way < 2};
    const std::vector<Point> even = evenly(points, false, length);
    if (const auto name = arc_name(even, length, std::max(tolerance, 0.02 * length))) return *name;
    if (direct && off <= 0.05 * chord) return {phrase(kNearlyStraight[way]), way < 2};
    const std::vector<Point> corners = corners_of(points, false, tolerance);
    bool sharp = corners.size() >= 3 && corners.size() <= 6;
    for (std::size_t i = 1; sharp && i + 1 < corners.size(); ++i)
        sharp = std::abs(angle_between(direction(corners[i - 1], corners[i]), direction(corners[i], corners[i + 1]))) > pi / 6;
    if (sharp && corners.size() == 3) return {phrase("line with one corner")};
    if (sharp) return {phrase("line with {0} corners", std::to_string(corners.size() - 2))};
    if (chord > 0.5 * length && is_wavy(even)) return {phrase(kWavy[way])};
    if (chord >= 0.9 * length) return {phrase(kSlightlyCurved[way])};
    return {length > 2.5 * std::hypot(box.width, box.height) ? phrase("winding line") : phrase("curved line")};
}

double turn_of(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

Point corner(const Shape& shape, std::size_t i) { return shape.corners[i % shape.corners.size()]; }
std::size_t sides(const Shape& shape) { return shape.corners.size() - (shape.closed ? 0 : 1); }

bool apart(const Rect& a, const Rect& b, double gap) {
    return a.left > b.left + b.width + gap || b.left > a.left + a.width + gap || a.top > b.top + b.height + gap ||
           b.top > a.top + a.height + gap;
}

}  // namespace

double length_of(std::span<const Point> points, bool closed) {
    double length = closed ? distance(points.back(), points.front()) : 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
    return length;
}

Phrase spoken_length(double mm) {
    if (mm >= 995) return phrase("{0} m", numeral(std::round(mm / 100) / 10));
    if (mm >= 97.5) return phrase("{0} cm", numeral(std::round(mm / 10)));
    if (mm >= 9.75) return phrase("{0} cm", numeral(std::round(mm / 5) / 2));
    return phrase("{0} mm", numeral(std::max(1.0, std::round(mm))));
}

Phrase spoken_size(const Rect& box) {
    return phrase("{0} wide and {1} high", spoken_length(box.width), spoken_length(box.height));
}

Shape shape_of(std::span<const Point> points, bool closed) {
    Shape shape;
    shape.box = rect_of(box_of(points));
    const std::vector<Point> few = thinned(points);
    const double side = std::max(shape.box.width, shape.box.height);
    const double tolerance = std::max(kNear, kNearPart * side);
    const double gap = distance(points.front(), points.back());
    shape.closed = closed || (gap <= kClosedGap && side > 5 * kClosedGap);
    shape.length = length_of(points, shape.closed);
    for (double within = 0.5; shape.corners.empty() || shape.corners.size() > kMostCorners; within *= 2)
        shape.corners = corners_of(few, shape.closed, within);

    constexpr double kDot = 4, kMark = 8;  // mm; below half an inch no shape is recognised (APH guide), a line from 6.4 mm on
    if (side <= kDot) {
        shape.name = shape.area = phrase("dot");
        shape.size = phrase("{0} across", spoken_length(side));
    } else if (side <= kMark) {
        shape.name = shape.area = phrase("small mark");
        shape.size = phrase("{0} across", spoken_length(side));
    } else if (shape.closed) {
        ClosedName name = closed_name(few, shape.box, length_of(few, true), tolerance);
        shape.size = name.outline == phrase(kCircle)
                         ? phrase("{0} across", spoken_length((shape.box.width + shape.box.height) / 2))
                         : spoken_size(shape.box);
        shape.name = std::move(name.outline);
        shape.area = std::move(name.area);
    } else {
        OpenName name = open_name(few, shape.box, length_of(few, false), tolerance);
        const bool doubles_back = shape.length > 1.6 * gap && !name.circle;
        shape.size = doubles_back ? phrase("{0} long in a space {1}", spoken_length(shape.length), spoken_size(shape.box))
                                  : phrase("{0} long", spoken_length(shape.length));
        shape.name = shape.area = std::move(name.name);
        shape.level = name.level;
    }
    return shape;
}

bool cross(const Shape& a, const Shape& b) {
    if (apart(a.box, b.box, 0)) return false;
    const auto at_an_end = [](const Shape& shape, Point p) {
        return !shape.closed && std::min(distance(p, shape.corners.front()), distance(p, shape.corners.back())) <= kClosedGap;
    };
    for (std::size_t i = 0; i < sides(a); ++i)
        for (std::size_t j = 0; j < sides(b); ++j) {
            const Point p = corner(a, i), q = corner(a, i + 1), r = corner(b, j), s = corner(b, j + 1);
            const double before = turn_of(r, s, p), behind = turn_of(r, s, q);
            if (!(turn_of(p, q, r) * turn_of(p, q, s) < 0 && before * behind < 0)) continue;
            const double t = before / (before - behind);
            const Point at{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
            if (!at_an_end(a, at) && !at_an_end(b, at)) return true;
        }
    return false;
}

bool holds(const Shape& ring, Point p) {
    bool inside = false;
    for (std::size_t i = 0; i < sides(ring); ++i) {
        if (ray_meets(p, corner(ring, i), corner(ring, i + 1))) inside = !inside;
    }
    return inside;
}

bool is_inside(const Shape& a, const Shape& ring) {
    if (!ring.closed || ring.corners.size() < 3) return false;
    return std::all_of(a.corners.begin(), a.corners.end(), [&](Point p) { return holds(ring, p); }) && !cross(a, ring);
}

bool end_meets(const Shape& a, const Shape& b) {
    if (a.closed || apart(a.box, b.box, kClosedGap)) return false;
    for (const Point end : {a.corners.front(), a.corners.back()})
        for (std::size_t i = 0; i < sides(b); ++i) {
            const Point p = corner(b, i), q = corner(b, i + 1);
            const double dx = q.x - p.x, dy = q.y - p.y, square = dx * dx + dy * dy;
            const double t = square > 0 ? std::clamp(((end.x - p.x) * dx + (end.y - p.y) * dy) / square, 0.0, 1.0) : 0;
            if (distance(end, {p.x + t * dx, p.y + t * dy}) <= kClosedGap) return true;
        }
    return false;
}

}  // namespace tactics
