// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/rings.h"

#include <algorithm>
#include <cmath>

#include "tactics/geometry/course.h"
#include "tactics/geometry/triangulate.h"

namespace tactics {

namespace {

// Comparing every ring with every other ends at so many points: then the rings stay as they are.
constexpr double kMostWork = 50e6;

bool contains(const std::vector<Point>& ring, Point p) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        if (ray_meets(p, a, b)) inside = !inside;
    }
    return inside;
}

}  // namespace

std::vector<std::vector<Point>> to_even_odd(std::vector<std::vector<Point>> rings) {
    double points = 0;
    for (const auto& ring : rings) points += static_cast<double>(ring.size());
    if (rings.size() < 2 || points * static_cast<double>(rings.size()) > kMostWork) return rings;
    std::vector<std::vector<Point>> edges;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        int around = 0;  // turns round this ring by all others
        for (std::size_t j = 0; j < rings.size(); ++j)
            if (j != i && contains(rings[j], rings[i][0])) around += doubled_area(rings[j]) > 0 ? 1 : -1;
        const int within = around + (doubled_area(rings[i]) > 0 ? 1 : -1);
        // Black on both sides, it is no edge.
        if ((around != 0) != (within != 0)) edges.push_back(rings[i]);
    }
    return edges;
}

}  // namespace tactics
