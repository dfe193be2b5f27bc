// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/mesh_ball.h"

#include <algorithm>
#include <array>
#include <limits>

namespace tactics {

namespace {

// A way along a round edge that leads in by no more than kIn mm only grazes: a small ball's middle is not known better. By a
// face, one that leads nearer by less than kLevel of its length.
constexpr double kIn = 1e-11, kLevel = 1e-11;
// mm beyond the end of an edge that are still on it: along two edges that are almost in line, rounding puts the place where a
// ball leaves one and meets the other before the corner between them, which it only grazes.
constexpr double kPastEnd = 1e-7;

struct Foot {
    Point3 place;
    FacetFeature feature;
    Point3 along;  // of the edge
};

Foot foot_on_edge(const Point3& from, const Point3& way, double share) noexcept {
    return {from + share * way, FacetFeature::edge, way};
}

// C. Ericson, Real-Time Collision Detection (2005), 5.1.5.
Foot foot_of(const FacetCorners& f, const Point3& ball) noexcept {
    const Point3 ab = f.b - f.a, ac = f.c - f.a, ap = ball - f.a;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return {f.a, FacetFeature::corner, {}};
    const Point3 bp = ball - f.b;
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return {f.b, FacetFeature::corner, {}};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return foot_on_edge(f.a, ab, d1 / (d1 - d3));
    const Point3 cp = ball - f.c;
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return {f.c, FacetFeature::corner, {}};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return foot_on_edge(f.a, ac, d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return foot_on_edge(f.b, f.c - f.b, (d4 - d3) / ((d4 - d3) + (d5 - d6)));
    return {{}, FacetFeature::face, {}};
}

// When a point that is `off` a line and goes `across` it comes within `radius`: both already without what goes along the line.
// Never where it is led in by no more than kIn on the whole way, as by rounding where it goes along the line.
double meets_round(const Point3& off, const Point3& across, double radius) noexcept {
    const double towards = dot(off, across), squared = dot(across, across);
    if (towards >= 0) return kMeetsNever;
    const double nearest = -towards / squared;  // in time
    const Point3 miss = off + nearest * across, last = off + std::min(nearest, 1.0) * across;
    const double half = radius * radius - dot(miss, miss);
    if (half <= 0 || std::min(radius, length_of(off)) - length_of(last) <= kIn) return kMeetsNever;
    return std::max(nearest - std::sqrt(half / squared), 0.0);
}

}  // namespace

FacetContact contact_of(const FacetCorners& facet, const Point3& ball, double radius) noexcept {
    const Foot foot = foot_of(facet, ball);
    FacetContact contact{foot.place, {}, 0, foot.feature, {}};
    const Point3 over = cross(facet.b - facet.a, facet.c - facet.a);
    const Point3 unit = (1 / length_of(over)) * over;
    const double height = dot(unit, ball - facet.a);
    if (foot.feature == FacetFeature::face) {
        contact.normal = height < 0 ? -1 * unit : unit;
        contact.gap = std::abs(height) - radius;
        contact.place = ball - height * unit;
        return contact;
    }
    const Point3 off = ball - foot.place;
    const double far = length_of(off);
    contact.gap = far - radius;
    contact.normal = far > 0 ? (1 / far) * off : unit;
    if (foot.feature == FacetFeature::edge) contact.axis = (1 / length_of(foot.along)) * foot.along;
    return contact;
}

double distance_to(const FacetCorners& facet, const Point3& place, double most) noexcept {
    const Point3 over = cross(facet.b - facet.a, facet.c - facet.a);
    const double height = dot(over, place - facet.a), squared = dot(over, over);
    if (height * height > most * most * squared * (1 + 1e-12)) return std::numeric_limits<double>::infinity();
    const Foot foot = foot_of(facet, place);
    if (foot.feature == FacetFeature::face) return std::abs(height) / std::sqrt(squared);
    return length_of(place - foot.place);
}

double meeting(const FacetCorners& facet, const Point3& ball, const Point3& way, double length, double radius,
               double before) noexcept {
    const Point3 over = cross(facet.b - facet.a, facet.c - facet.a);
    const Point3 unit = (1 / length_of(over)) * over;
    const double height = dot(unit, ball - facet.a), side = height < 0 ? -1 : 1, nearer = -side * dot(unit, way);
    const double apart = side * height - radius;
    double share = 0;
    if (apart > 0) {
        if (nearer <= 0 || apart > nearer * before) return kMeetsNever;
        share = apart / nearer;
    }
    // The place of its plane that the ball then touches, or the foot of its middle: when is it in the facet?
    const double down = apart > 0 ? side * radius : height;
    const Point3 foot = ball + share * way - down * unit;
    const std::array<Point3, 3> corners{facet.a, facet.b, facet.c};
    double enters = 0, leaves = before - share;
    const double reach = radius * radius * dot(over, over) * (1 + 1e-6);
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3 &from = corners[k], edge = corners[(k + 1) % 3] - from;
        const Point3 inward = cross(over, edge);
        const double in = dot(inward, foot - from), rate = dot(inward, way);
        // It stays beyond that side by more than the ball reaches.
        const double most_in = std::max(in, in + rate * (before - share));
        if (most_in < 0 && most_in * most_in > reach * dot(edge, edge)) return kMeetsNever;
        if (in < 0)
            enters = rate > 0 ? std::max(enters, -in / rate) : kMeetsNever;
        else if (rate < 0)
            leaves = std::min(leaves, -in / rate);
    }
    const bool faces = nearer > kLevel * length;
    if (faces) leaves = std::min(leaves, (side * height + radius) / nearer - share);  // then it is through the plane
    if (enters <= 0) return faces ? share : kMeetsNever;
    // Before its face a ball meets an edge or a corner of it, unless it only grazes that.
    double first = faces && enters <= leaves ? share + enters : kMeetsNever;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3 off = ball - corners[k], edge = corners[(k + 1) % 3] - corners[k];
        first = std::min(first, meets_round(off, way, radius));
        const double squared = dot(edge, edge), start = dot(off, edge) / squared, rate = dot(way, edge) / squared;
        const double when = meets_round(off - start * edge, way - rate * edge, radius), at = start + rate * when;
        const double beyond = kPastEnd / std::sqrt(squared);
        if (when < first && at >= -beyond && at <= 1 + beyond) first = when;
    }
    return first <= before ? first : kMeetsNever;
}

}  // namespace tactics
