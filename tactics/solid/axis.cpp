// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tactics {

namespace {

constexpr int kRounds = 24;               // of weighing again
constexpr double kMiss = 0.04;            // of the size, within which a normal meets an axis
constexpr double kMissing = 0.25;         // of the surface, which a handle may have
constexpr double kOneDirection = 0.9999;  // cosine of two directions that are one: 0.8 degrees

// A facet by its middle and the way it looks.
struct Facet {
    Point3 at, normal;
    double area = 0;
};

struct Facets {
    std::vector<Facet> all;
    double size = 0;  // mean distance from the middle, which is the origin
    double area = 0;
    Point3 middle;
};

Point3 middle_by_area(const Patch& patch) {
    Point3 sum;
    double all = 0;
    for (const auto& ring : patch.rings)
        for (std::size_t i = 2; i < ring.size(); ++i) {
            const double area = dot(patch.normal, cross(ring[i - 1] - ring[0], ring[i] - ring[0]));
            sum = sum + (area / 3) * (ring[0] + ring[i - 1] + ring[i]);
            all += area;
        }
    return std::abs(all) > 1e-12 ? (1 / all) * sum : middle_of(patch);
}

Facets facets_of(const Solid& solid) {
    Facets facets;
    for (const Patch& patch : solid.patches) {
        facets.all.push_back({middle_by_area(patch), patch.normal, patch.area});
        facets.middle = facets.middle + patch.area * facets.all.back().at;
        facets.area += patch.area;
    }
    facets.middle = (1 / facets.area) * facets.middle;
    for (Facet& facet : facets.all) {
        facet.at = facet.at - facets.middle;
        facets.size += facet.area / facets.area * length_of(facet.at);
    }
    return facets;
}

using Matrix = std::array<std::array<double, 3>, 3>;

// The directions in which a symmetrical matrix only stretches, and by how much, the least first (C. G. J. Jacobi, 1846).
struct Stretches {
    std::array<double, 3> by;
    std::array<Point3, 3> way;
};
Stretches stretches_of(Matrix a) {
    Matrix v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int round = 0; round < 30; ++round)
        for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
            if (std::abs(a[p][q]) < 1e-300) continue;
            const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
            const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
            const double c = 1 / std::sqrt(t * t + 1), s = t * c;
            for (std::size_t k = 0; k < 3; ++k) {
                const double one = a[k][p], other = a[k][q];
                a[k][p] = c * one - s * other;
                a[k][q] = s * one + c * other;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double one = a[p][k], other = a[q][k], left = v[k][p], right = v[k][q];
                a[p][k] = c * one - s * other;
                a[q][k] = s * one + c * other;
                v[k][p] = c * left - s * right;
                v[k][q] = s * left + c * right;
            }
        }
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return a[i][i] < a[j][j]; });
    Stretches found;
    for (std::size_t i = 0; i < 3; ++i) {
        found.by[i] = a[order[i]][order[i]];
        found.way[i] = {v[0][order[i]], v[1][order[i]], v[2][order[i]]};
    }
    return found;
}

void add(Matrix& sum, double weight, const Point3& a, const Point3& b) {
    const double left[] = {a.x, a.y, a.z}, right[] = {b.x, b.y, b.z};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) sum[i][j] += weight * left[i] * right[j];
}

Point3 times(const Matrix& m, const Point3& v) {
    return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
            m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

// How far the line along a facet's normal passes by an axis, mm.
double miss(const Facet& facet, const SpaceLine& axis) {
    return std::abs(dot(axis.along, cross(facet.at - axis.at, facet.normal)));
}

// The axis in that direction that the normals pass nearest, by the sum of distances, so that a handle does not draw it aside.
SpaceLine along(const Facets& facets, const Point3& direction) {
    SpaceLine axis{{}, direction};
    for (int round = 0; round < kRounds; ++round) {
        double xx = 0, xy = 0, yy = 0, x = 0, y = 0;
        const Point3 u = unit(std::abs(direction.z) < 0.9 ? cross({0, 0, 1}, direction) : cross({1, 0, 0}, direction)),
                     v = cross(direction, u);
        for (const Facet& facet : facets.all) {
            const double weight = facet.area / (miss(facet, axis) + 1e-3 * facets.size);
            // The axis through a: a . (n x d) = d . (at x n).
            const Point3 way = cross(facet.normal, direction);
            const double a = dot(way, u), b = dot(way, v), off = dot(direction, cross(facet.at, facet.normal));
            xx += weight * a * a;
            xy += weight * a * b;
            yy += weight * b * b;
            x += weight * a * off;
            y += weight * b * off;
        }
        const double both = xx * yy - xy * xy;
        if (!(both > 1e-9 * (xx + yy) * (xx + yy))) break;
        axis.at = ((yy * x - xy * y) / both) * u + ((xx * y - xy * x) / both) * v;
    }
    return axis;
}

// The axis that all normals pass nearest.
SpaceLine by_normals(const Facets& facets) {
    SpaceLine axis{{}, {0, 0, 1}};
    for (int round = 0; round < kRounds; ++round) {
        Matrix turning{}, both{}, looking{};
        const double near = std::max(1e-4, std::pow(0.6, round));
        for (const Facet& facet : facets.all) {
            const double weight = facet.area / ((round == 0 ? 0 : miss(facet, axis)) + near * facets.size);
            const Point3 turn = cross(facet.at, facet.normal);
            add(turning, weight, turn, turn);
            add(both, weight, turn, facet.normal);
            add(looking, weight, facet.normal, facet.normal);
        }
        // The moment that is best for a direction d is -m d; along directions in which nothing looks there is none.
        const Stretches looks = stretches_of(looking);
        Matrix inverse{};
        for (std::size_t i = 0; i < 3; ++i)
            if (looks.by[i] > 1e-4 * looks.by[2]) add(inverse, 1 / looks.by[i], looks.way[i], looks.way[i]);
        Matrix rest = turning, m{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t k = 0; k < 3; ++k) m[i][j] += inverse[i][k] * both[j][k];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t k = 0; k < 3; ++k) rest[i][j] -= both[i][k] * m[k][j];
        axis.along = unit(stretches_of(rest).way[0]);
        // A place on it from its moment, at x along.
        axis.at = cross(axis.along, -1 * times(m, axis.along));
    }
    return axis;
}

}  // namespace

bool any_axis(const Solid& solid, const std::function<bool(const SpaceLine&)>& take) {
    const Facets facets = facets_of(solid);
    if (!(facets.size > 0)) return false;
    std::vector<Point3> tried;
    const auto is_taken = [&](SpaceLine axis) {
        double missing = 0;
        for (const Facet& facet : facets.all)
            if (miss(facet, axis) > kMiss * facets.size) missing += facet.area;
        if (missing > kMissing * facets.area) return false;
        tried.push_back(axis.along);
        if (dot(axis.along, Point3{1e-6, 1e-3, 1}) < 0) axis.along = -1 * axis.along;
        axis.at = facets.middle + axis.at - dot(axis.at, axis.along) * axis.along;
        return take(axis);
    };
    for (const Point3& direction : {Point3{0, 0, 1}, Point3{1, 0, 0}, Point3{0, 1, 0}})
        if (is_taken(along(facets, direction))) return true;
    const Point3 leaning = by_normals(facets).along;
    const auto is_same = [&](const Point3& one) { return std::abs(dot(one, leaning)) > kOneDirection; };
    return std::none_of(tried.begin(), tried.end(), is_same) && is_taken(along(facets, leaning));
}

}  // namespace tactics
