#include "filters/ridge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tactics {

namespace {

struct Profile {
    double before, here, after;  // strength one pixel to either side, across the edge
    Point normal;
};

double strength_at(const EdgeMap& edges, int x, int y) {
    if (x < 0 || y < 0 || x >= edges.width || y >= edges.height) return 0;
    return static_cast<double>(
        edges.strength[static_cast<std::size_t>(y) * static_cast<std::size_t>(edges.width) + static_cast<std::size_t>(x)]);
}

// Between pixels; (x, y) is the middle of a pixel.
double strength_between(const EdgeMap& edges, double x, double y) {
    const double fx = std::floor(x), fy = std::floor(y), tx = x - fx, ty = y - fy;
    const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
    return (1 - ty) * ((1 - tx) * strength_at(edges, ix, iy) + tx * strength_at(edges, ix + 1, iy)) +
           ty * ((1 - tx) * strength_at(edges, ix, iy + 1) + tx * strength_at(edges, ix + 1, iy + 1));
}

struct Bend {
    double angle;  // in which the strength is bent down most: the Hessian's lowest eigenvalue; across the edge on a ridge
    bool ridge;    // it is bent down more than up
};

Bend bend_at(const EdgeMap& edges, int x, int y) {
    const double here = 2 * strength_at(edges, x, y);
    const double xx = strength_at(edges, x - 1, y) + strength_at(edges, x + 1, y) - here;
    const double yy = strength_at(edges, x, y - 1) + strength_at(edges, x, y + 1) - here;
    const double xy = (strength_at(edges, x + 1, y + 1) + strength_at(edges, x - 1, y - 1) - strength_at(edges, x + 1, y - 1) -
                       strength_at(edges, x - 1, y + 1)) /
                      4;
    return {std::atan2(-2 * xy, yy - xx) / 2, xx + yy < 0};
}

double angle_at(const EdgeMap& edges, int x, int y) {
    if (edges.normal.empty()) return bend_at(edges, x, y).angle;
    return static_cast<double>(
        edges.normal[static_cast<std::size_t>(y) * static_cast<std::size_t>(edges.width) + static_cast<std::size_t>(x)]);
}

Profile profile_at(const EdgeMap& edges, int x, int y, double angle) {
    const Point normal{std::cos(angle), std::sin(angle)};
    return {strength_between(edges, x - normal.x, y - normal.y), strength_at(edges, x, y),
            strength_between(edges, x + normal.x, y + normal.y), normal};
}

}  // namespace

EdgeMap ridges_of(const EdgeMap& edges) {
    EdgeMap ridges = edges;
    ridges.thinned = true;
    ridges.strength.assign(edges.strength.size(), 0.0f);
    std::size_t i = 0;
    for (int y = 0; y < edges.height; ++y) {
        for (int x = 0; x < edges.width; ++x, ++i) {
            if (edges.strength[i] <= 0 || (edges.normal.empty() && !bend_at(edges, x, y).ridge)) continue;
            const Profile p = profile_at(edges, x, y, angle_at(edges, x, y));
            if (p.here > p.before && p.here >= p.after) ridges.strength[i] = edges.strength[i];
        }
    }
    return ridges;
}

Point on_ridge(const EdgeMap& edges, Point at) {
    const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
    if (x < 0 || y < 0 || x >= edges.width || y >= edges.height) return at;
    const Profile p = profile_at(edges, x, y, angle_at(edges, x, y));
    const double bend = p.before - 2 * p.here + p.after;
    if (bend >= 0) return at;
    const double shift = std::clamp((p.before - p.after) / (2 * bend), -1.0, 1.0);
    return {x + 0.5 + shift * p.normal.x, y + 0.5 + shift * p.normal.y};
}

}  // namespace tactics
