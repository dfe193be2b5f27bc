// SPDX-License-Identifier: Apache-2.0
// A mesh with no more facets than a device can tell.
#pragma once

#include <string>

#include "tactics/haptics/scenes/mesh_facets.h"

namespace tactics {

struct EnoughMesh {
    MeshFacets facets;
    std::size_t of_all = 0;  ///< facets that there were
    double error = 0;        ///< mm: no place of either surface is further from the other than that
    std::string words;       ///< a sentence: what was dropped
};

/// Corners are drawn into a neighbour, one after another, while the surface stays within `tolerance` (mm) of what it was. Seen
/// along the mean direction of the facets around a corner, those before and those after cover the same places, so that their
/// greatest distance along it is where their edges cross, and bounds how far either surface is from the other (after J. Cohen, D.
/// Manocha, M. Olano, "Simplifying polygonal models using successive mappings", 1997; from memory). These bounds are added up,
/// facet by facet. Borders and edges where three facets meet stay as they are, and so does whether the mesh is closed. A ball
/// feels the difference no more than a point does: surfaces that are so near have places at any distance from them that are as
/// near.
EnoughMesh enough_facets(MeshFacets facets, double tolerance);

}  // namespace tactics
