// SPDX-License-Identifier: Apache-2.0
// Meshes to be felt, and the naive twin of what finds places on them: all facets, one after another, in long double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "tactics/measure/random.h"
#include "tactics/mesh.h"

namespace tactics::tests {

inline Mesh mesh_with(std::vector<Point3> vertices, std::vector<std::array<std::uint32_t, 3>> triangles) {
    return {std::move(vertices), std::move(triangles), {}};
}

inline Mesh box_mesh(const Point3& low, const Point3& high) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < 8; ++i)
        mesh.vertices.push_back({(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// A ball around 0 whose radius depends on the direction: an octahedron, each facet cut in four so often.
inline Mesh ball_mesh(int cuts, const std::function<double(const Point3& direction)>& radius) {
    Mesh mesh = mesh_with({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
    for (int cut = 0; cut < cuts; ++cut) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        std::vector<std::array<std::uint32_t, 3>> finer;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, fresh] =
                middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (fresh) {
                const Point3 sum = mesh.vertices[a] + mesh.vertices[b];
                mesh.vertices.push_back((1 / length_of(sum)) * sum);
            }
            return at->second;
        };
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    for (Point3& vertex : mesh.vertices) vertex = radius(vertex) * vertex;
    return mesh;
}

inline Mesh star_mesh(int cuts, std::uint64_t seed) {
    RandomNumbers random(seed);
    return ball_mesh(cuts, [&](const Point3&) { return 4 + 8 * random.uniform(); });
}

/// Triangles of any shape that pass through one another.
inline Mesh soup_mesh(int count, std::uint64_t seed) {
    RandomNumbers random(seed);
    const auto anywhere = [&](double wide) {
        return Point3{wide * (random.uniform() - 0.5), wide * (random.uniform() - 0.5), wide * (random.uniform() - 0.5)};
    };
    Mesh mesh;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
        const Point3 middle = anywhere(20);
        for (int k = 0; k < 3; ++k) mesh.vertices.push_back(middle + anywhere(8));
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

using Exact = long double;
struct Exact3 {
    Exact x, y, z;
    explicit Exact3(const Point3& p) : x(p.x), y(p.y), z(p.z) {}
    Exact3(Exact x_, Exact y_, Exact z_) : x(x_), y(y_), z(z_) {}
};
inline Exact3 operator-(const Exact3& a, const Exact3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Exact3 operator+(const Exact3& a, const Exact3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Exact3 operator*(Exact by, const Exact3& a) { return {by * a.x, by * a.y, by * a.z}; }
inline Exact dot(const Exact3& a, const Exact3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Exact3 cross(const Exact3& a, const Exact3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// From a place to the nearest of a triangle: the foot on its plane if that is in it, else the nearest of its three sides.
inline Exact3 nearest_by_sides(const Exact3& p, const std::array<Exact3, 3>& corners) {
    const Exact3 over = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const Exact3 foot = p - (dot(p - corners[0], over) / dot(over, over)) * over;
    bool within = true;
    Exact3 best = corners[0];
    Exact least = INFINITY;
    for (std::size_t k = 0; k < 3; ++k) {
        const Exact3 &a = corners[k], side = corners[(k + 1) % 3] - a;
        within = within && dot(cross(side, foot - a), over) >= 0;
        const Exact3 at = a + std::clamp<Exact>(dot(p - a, side) / dot(side, side), 0, 1) * side;
        if (dot(p - at, p - at) < least) {
            least = dot(p - at, p - at);
            best = at;
        }
    }
    return within ? foot : best;
}

inline std::array<Exact3, 3> exact_corners(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    return {Exact3(mesh.vertices[triangle[0]]), Exact3(mesh.vertices[triangle[1]]), Exact3(mesh.vertices[triangle[2]])};
}

inline double distance_to(const Mesh& mesh, const Point3& place) {
    const Exact3 p(place);
    Exact least = INFINITY;
    for (const auto& triangle : mesh.triangles) {
        const Exact3 off = p - nearest_by_sides(p, exact_corners(mesh, triangle));
        least = std::min(least, dot(off, off));
    }
    return static_cast<double>(std::sqrt(least));
}

/// How often the mesh winds around a place, by solid angles: 1 within a closed mesh, 0 outside. A. Van Oosterom and J. Strackee,
/// "The solid angle of a plane triangle" (1983).
inline double winding_of(const Mesh& mesh, const Point3& place) {
    const Exact3 p(place);
    Exact sum = 0;
    for (const auto& triangle : mesh.triangles) {
        const auto corners = exact_corners(mesh, triangle);
        const Exact3 a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
        const Exact la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
        sum += 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return static_cast<double>(sum / (4 * std::acos(Exact{-1})));
}

}  // namespace tactics::tests
