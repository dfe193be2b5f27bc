// SPDX-License-Identifier: Apache-2.0
// A mesh prepared for touch: without duplicate triangles and triangles without area.
#pragma once

#include <string>
#include <vector>

#include "tactics/mesh.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Narrower triangles (mm across) are left out: a finger is never smaller than kLeastFinger and cannot pass through the gap.
inline constexpr double kLeastFacet = 1e-6;
/// mm: the radius of a point-like finger. It keeps the point off the seams between facets, where precision ends.
inline constexpr double kLeastFinger = 1e-5;

struct MeshFacets {
    std::vector<Point3> corners;  ///< no two in the same place
    std::vector<std::array<std::uint32_t, 3>> facets;
    std::size_t without_area = 0, twice = 0;  ///< triangles left out
    std::size_t open_edges = 0;               ///< edges with a facet on one side only
    std::size_t crowded_edges = 0;            ///< edges where three or more facets meet
    bool closed = false;                      ///< every edge joins two facets that face the same way: there is an inside
};

/// Throws std::logic_error for an invalid mesh (mesh.h): a vertex that is not finite or does not exist, or too many.
MeshFacets facets_of(const Mesh& mesh);

/// Notes on omitted parts and on other things a user should know, one sentence each.
std::vector<Phrase> notes_on(const MeshFacets& facets);

/// Unit vectors, one per corner: the mean of the facets around it, weighted by their angles there (G. Thuermer, C. A. Wuethrich,
/// "Computing vertex normals from polygonal facets", 1998; from memory). 0 if they cancel out.
std::vector<Point3> corner_normals(const MeshFacets& facets);

}  // namespace tactics
