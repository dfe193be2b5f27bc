// SPDX-License-Identifier: Apache-2.0
// Height surfaces as facets, no more than a device can resolve.
#pragma once

#include <string>

#include "tactics/mesh.h"
#include "tactics/plot.h"
#include "tactics/relief/heightmap.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Two facets for each square of four known samples, cut from its upper left to its lower right corner; y upwards, so that they
/// face up. Of each row and column it uses every `every`-th sample (1 or more) and the last. Throws std::logic_error if there
/// would be more than a mesh may have.
Mesh mesh_of(const HeightMap& map, int every = 1);

/// A plotted surface in a box of that size (mm) with its lower corner at 0; each axis runs from its smallest value to its
/// largest.
Mesh mesh_of(const PlotSurface& surface, const Point3& size);

struct EnoughFacets {
    int every = 1;                       ///< for mesh_of
    std::size_t facets = 0, of_all = 0;  ///< facets kept, and facets of the full surface
    double error = 0;                    ///< mm: the greatest height of an omitted sample above or below the facets
    Phrase words;                        ///< a sentence: what was dropped
};
/// The coarsest facets whose distance from the map is everywhere below the device's `resolution` (mm). Holes count as 0.
EnoughFacets enough_facets(const HeightMap& map, double resolution);

}  // namespace tactics
