// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/outline_measure.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

// Of the polygon: Green's theorem gives area and moments side by side.
struct Moments {
    double area = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;

    void add(Point a, Point b) {
        const double cross = a.x * b.y - b.x * a.y;
        area += cross / 2;
        x += (a.x + b.x) * cross / 6;
        y += (a.y + b.y) * cross / 6;
        xx += (a.x * a.x + a.x * b.x + b.x * b.x) * cross / 12;
        yy += (a.y * a.y + a.y * b.y + b.y * b.y) * cross / 12;
        xy += (2 * a.x * a.y + a.x * b.y + b.x * a.y + 2 * b.x * b.y) * cross / 24;
    }
};

double root(double square) { return std::sqrt(std::max(square, 0.0)); }

OutlineMeasure measure(const std::vector<std::vector<Point>>& rings, double down) {
    OutlineMeasure out;
    Moments sum;
    double rim = 0, left = 0, right = 0, low = 0, high = 0;
    bool any = false;
    for (const auto& ring : rings) {
        if (ring.size() < 3) continue;
        ++out.rings;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a{ring[i].x, down * ring[i].y}, next = ring[(i + 1) % ring.size()], b{next.x, down * next.y};
            out.corners += distance(a, b) > 0 ? 1 : 0;
            sum.add(a, b);
            rim += distance(a, b);
            left = any ? std::min(left, a.x) : a.x;
            right = any ? std::max(right, a.x) : a.x;
            low = any ? std::min(low, a.y) : a.y;
            high = any ? std::max(high, a.y) : a.y;
            any = true;
        }
    }
    if (!(std::abs(sum.area) > 0) || !std::isfinite(sum.area)) return out;
    const double x = sum.x / sum.area, y = sum.y / sum.area;
    const double across = root(sum.xx / sum.area - x * x), up = root(sum.yy / sum.area - y * y), both = std::hypot(across, up);
    out.area = std::abs(sum.area);
    out.lengths = {right - left, low, high, x - left, y, across, up, both > 0 ? (sum.xy / sum.area - x * y) / both : 0,
                   rim / 8};  // a rim is long, and its flattening counts in all of it
    return out;
}

}  // namespace

OutlineMeasure measure_rings(const std::vector<std::vector<Point>>& rings) { return measure(rings, -1); }

OutlineMeasure measure_letter(const Letter& letter) {
    constexpr int kPieces = 16;  // of a curve
    std::vector<std::vector<Point>> rings;
    Point at;
    const auto point = [](const LetterCorner& corner) { return Point{corner.x / 1000.0, corner.y / 1000.0}; };
    for (const OutlineStep& step : letter.outline) {
        if (step.kind == OutlineStep::Kind::move) rings.emplace_back();
        if (rings.empty()) continue;
        if (step.kind == OutlineStep::Kind::curve) {
            const Point a = point(step.corners[0]), b = point(step.corners[1]), end = point(step.corners[2]);
            for (int i = 1; i <= kPieces; ++i) {
                const double t = static_cast<double>(i) / kPieces, u = 1 - t;
                const double p = u * u * u, q = 3 * u * u * t, r = 3 * u * t * t, s = t * t * t;
                rings.back().push_back({p * at.x + q * a.x + r * b.x + s * end.x, p * at.y + q * a.y + r * b.y + s * end.y});
            }
            at = end;
        } else {
            at = point(step.corners[0]);
            rings.back().push_back(at);
        }
    }
    return measure(rings, 1);
}

double apart_but_for_ink(const OutlineMeasure& shape, const OutlineMeasure& letter, double em) {
    if (shape.rings != letter.rings || !(em > 0)) return 1;
    double apart = 0;
    for (std::size_t i = 0; i < shape.lengths.size(); ++i)
        apart = std::max(apart, std::abs(shape.lengths[i] / em - letter.lengths[i]));
    return apart;
}

double apart_at(const OutlineMeasure& shape, const OutlineMeasure& letter, double em) {
    return std::max(apart_but_for_ink(shape, letter, em), std::abs(std::sqrt(shape.area) / em - std::sqrt(letter.area)));
}

}  // namespace tactics
