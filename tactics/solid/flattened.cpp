// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/flattened.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tactics/geometry/course.h"

namespace tactics {

namespace {

constexpr double kAsClose = 1e-3;    // of two distances, by which they may differ and be the same
constexpr double kNearBorder = 0.2;  // of the holder's smaller extent: farther in, a bar stands in its middle

Point towards(Point from, Point to) {
    const double length = distance(from, to);
    return length > 0 ? Point{(to.x - from.x) / length, (to.y - from.y) / length} : Point{};
}

FlatBar bar(Point from, Point direction, double length) {
    const double size = std::hypot(direction.x, direction.y);
    return {from, {from.x + length * direction.x / size, from.y + length * direction.y / size}};
}

}  // namespace

std::vector<FlatBar> ways_to_flatten(const FlatShape& holder, Point held, double length) {
    const double near = kNearBorder * std::min(holder.box.width(), holder.box.height());
    const std::vector<Point>& ring = holder.rings.front();
    std::size_t corner = 0, side = 0;
    double to_corner = std::numeric_limits<double>::infinity(), to_side = to_corner;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (distance(ring[i], held) < (1 - kAsClose) * to_corner) {
            to_corner = distance(ring[i], held);
            corner = i;
        }
        const double off = distance_to_segment(held, ring[i], ring[(i + 1) % ring.size()]);
        if (off < (1 - kAsClose) * to_side) {
            to_side = off;
            side = i;
        }
    }
    std::vector<FlatBar> ways;
    // Two sides that hardly turn are a curve, and no corner.
    const Point &before = ring[(corner + ring.size() - 1) % ring.size()], &at = ring[corner],
                &after = ring[(corner + 1) % ring.size()];
    const Point one = towards(before, at), other = towards(after, at);
    const bool is_corner = std::abs(one.x * other.y - one.y * other.x) > 0.5;
    if (to_corner <= 1.5 * near && is_corner) {
        const double a = distance(before, at), b = distance(after, at);
        const Point out{a * one.x + b * other.x, a * one.y + b * other.y};
        if (std::hypot(out.x, out.y) > 1e-9 * (a + b)) {
            ways.push_back(bar(at, out, length));
            ways.push_back(bar(at, one, length));
            ways.push_back(bar(at, other, length));
            ways.push_back(bar(at, {-out.x, -out.y}, length));
        }
        return ways;
    }
    if (to_side > near) return ways;
    const Point &from = ring[side], &to = ring[(side + 1) % ring.size()];
    const Point along = towards(from, to);
    const double share = (held.x - from.x) * along.x + (held.y - from.y) * along.y;
    const Point on{from.x + share * along.x, from.y + share * along.y};
    Point out{along.y, -along.x};
    const Point probe{on.x + 0.01 * near * out.x, on.y + 0.01 * near * out.y};
    if (holds(holder, probe)) out = {-out.x, -out.y};
    ways.push_back(bar(on, out, length));
    ways.push_back(bar(on, {-out.x, -out.y}, length));
    return ways;
}

}  // namespace tactics
