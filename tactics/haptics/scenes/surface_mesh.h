// SPDX-License-Identifier: Apache-2.0
// Surfaces of heights as facets, and no more of them than a device can tell.
#pragma once

#include <string>

#include "tactics/mesh.h"
#include "tactics/plot.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

/// Two facets for each square of four samples, cut from its left upper to its right lower corner, where all its samples are
/// known; y upwards, so that they face up. Of each row and column only one sample in `every`, and the last; 1 or more.
/// std::logic_error where that is more than a mesh may have.
Mesh mesh_of(const HeightMap& map, int every = 1);

/// A plotted surface in a box of that size (mm), whose lower corner is 0: each axis from its least value to its greatest.
Mesh mesh_of(const PlotSurface& surface, const Point3& size);

struct EnoughFacets {
    int every = 1;                       ///< for mesh_of
    std::size_t facets = 0, of_all = 0;  ///< what is kept of what there would be
    double error = 0;                    ///< mm: the most that a sample left out is above or below the facets
    std::string words;                   ///< a sentence: what was dropped
};
/// The coarsest facets that are nowhere as far from the map as a device can tell (`resolution`, mm). Holes count as 0.
EnoughFacets enough_facets(const HeightMap& map, double resolution);

}  // namespace tactics
