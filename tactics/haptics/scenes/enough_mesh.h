// SPDX-License-Identifier: Apache-2.0
// A mesh with no more facets than a device can resolve.
#pragma once

#include <string>

#include "tactics/haptics/scenes/mesh_facets.h"

namespace tactics {

struct EnoughMesh {
    MeshFacets facets;
    std::size_t of_all = 0;  ///< original number of facets
    double error = 0;        ///< mm: no point of either surface is farther from the other
    Phrase words;            ///< a sentence about the dropped facets
};

/// Corners collapse into a neighbour, one after another, while the surface stays within `tolerance` (mm) of the original. Seen
/// along the mean direction of the facets around a corner, the facets before and after cover the same area, so their greatest
/// distance along it is where their edges cross; it bounds the distance of the two surfaces (after J. Cohen, D. Manocha, M.
/// Olano, "Simplifying polygonal models using successive mappings", 1997; from memory). These bounds are summed, facet by facet.
/// Borders and edges where three facets meet are unchanged, and a closed mesh stays closed. No facet is much steeper than those
/// that it stands for (each coordinate of its unit normal is within 0.1 of theirs). A ball feels the difference no more
/// than a point does: surfaces this close have offset surfaces that are equally close.
EnoughMesh enough_facets(MeshFacets facets, double tolerance);

}  // namespace tactics
