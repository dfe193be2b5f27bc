// SPDX-License-Identifier: Apache-2.0
// A ball and one facet: which place of the facet is nearest to it, and when it meets the facet on its way.
#pragma once

#include "tactics/point3.h"

namespace tactics {

struct FacetCorners {
    Point3 a, b, c;  ///< not on one line
};

enum class FacetFeature : unsigned char { face, edge, corner };

/// Where a ball touches a facet, or would.
struct FacetContact {
    Point3 place;    ///< of the facet, the nearest to the ball's middle
    Point3 normal;   ///< unit, from there to the ball's middle
    double gap = 0;  ///< mm from the ball to the facet; negative: it is that far in
    FacetFeature feature = FacetFeature::face;
    Point3 axis;  ///< unit, of an edge
};

FacetContact contact_of(const FacetCorners& facet, const Point3& ball, double radius) noexcept;

/// mm; infinite where it is more than `most`, or what it is
double distance_to(const FacetCorners& facet, const Point3& place, double most) noexcept;

/// The share of `way` (0 to `before`) after which the ball first meets the facet; `kMeetsNever` where it does not, or only grazes
/// it. A ball that touches it already meets it at 0 if the way leads nearer. `length` is that of the way.
double meeting(const FacetCorners& facet, const Point3& ball, const Point3& way, double length, double radius,
               double before) noexcept;
inline constexpr double kMeetsNever = 2;

}  // namespace tactics
