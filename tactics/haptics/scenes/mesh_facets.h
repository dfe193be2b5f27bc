// SPDX-License-Identifier: Apache-2.0
// A mesh made ready to be felt: what is in it twice or has no area is gone.
#pragma once

#include <string>
#include <vector>

#include "tactics/mesh.h"

namespace tactics {

/// A triangle so narrow (mm across) is left out: a finger is never smaller than kLeastFinger and cannot pass where it was.
inline constexpr double kLeastFacet = 1e-6;
/// mm: the radius of the finger that is a point. It keeps a point off the seams between facets, where numbers end.
inline constexpr double kLeastFinger = 1e-5;

struct MeshFacets {
    std::vector<Point3> corners;  ///< no two in the same place
    std::vector<std::array<std::uint32_t, 3>> facets;
    std::size_t without_area = 0, twice = 0;  ///< that were left out
    std::size_t open_edges = 0;               ///< with a facet on one side only
    std::size_t crowded_edges = 0;            ///< where three facets meet or more
    bool closed = false;                      ///< every edge joins two facets that face the same way: there is an inside
};

/// Throws std::logic_error for a mesh that breaks its own terms (mesh.h): a vertex that is not finite or not there, too many.
MeshFacets facets_of(const Mesh& mesh);

/// What was left out, and what a reader should know of it: a sentence each.
std::vector<std::string> notes_on(const MeshFacets& facets);

/// Unit vectors, one a corner: the facets around it, each by its angle there (G. Thuermer, C. A. Wuethrich, "Computing vertex
/// normals from polygonal facets", 1998; from memory). 0 where they cancel out.
std::vector<Point3> corner_normals(const MeshFacets& facets);

}  // namespace tactics
