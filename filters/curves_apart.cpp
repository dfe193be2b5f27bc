// SPDX-License-Identifier: Apache-2.0
#include "filters/curves_apart.h"

#include <algorithm>
#include <cmath>

#include "tactics/geometry/course.h"
#include "tactics/geometry/places.h"
#include "tactics/geometry/shape.h"

namespace tactics {

namespace {

constexpr double kStep = 0.25;       // mm from one place that is looked at to the next
constexpr double kTolerance = 0.05;  // mm

Box around(const std::vector<std::vector<Point>>& curves) {
    Box box = kNothing;
    for (const auto& curve : curves)
        for (const Point& p : curve) box.take(p);
    return box;
}

// With places in between, so that none is farther than kStep from the next.
std::vector<Point> dense(const std::vector<Point>& line) {
    std::vector<Point> places;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point a = line[i], b = line[i + 1];
        const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kStep)));
        for (int k = 0; k < steps; ++k) places.push_back({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps});
    }
    if (!line.empty()) places.push_back(line.back());
    return places;
}

}  // namespace

std::vector<std::vector<std::vector<Point>>> curves_apart(const std::vector<std::vector<Point>>& curves, double gap,
                                                          double least) {
    std::vector<std::vector<std::vector<Point>>> all;
    Places taken(around(curves), gap);
    for (const std::vector<Point>& curve : curves) {
        const std::vector<Point> line = course_of(curve, kTolerance);
        std::vector<std::vector<Point>> pieces;
        std::vector<Point> piece;
        const auto end = [&] {
            if (piece.size() > 1 && (all.empty() || length_of(piece, false) >= least))
                pieces.push_back(course_of(piece, kTolerance));
            piece.clear();
        };
        for (const Point& place : dense(line)) {
            if (!all.empty() && taken.any_near(place, gap, [&](std::size_t i) { return distance(taken[i], place) < gap; }))
                end();
            else
                piece.push_back(place);
        }
        end();
        for (const auto& kept : pieces)
            for (const Point& place : dense(kept)) taken.add(place);
        all.push_back(std::move(pieces));
    }
    return all;
}

}  // namespace tactics
