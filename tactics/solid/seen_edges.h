// SPDX-License-Identifier: Apache-2.0
// The view of parts from one side, without perspective: edges, and where they are hidden.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tactics/solid/joined_sides.h"
#include "tactics/solid/panel.h"

namespace tactics {

struct SeenEdges {
    /// mm of the model, x along ViewPlane::right and y along ViewPlane::down. LineClass::thick: nothing is behind it on one side,
    /// so that it is the outline of all; normal: the outline of a part before others; thin: a crease.
    std::vector<DrawnSide> edges;
    std::vector<std::uint32_t> part;  ///< of each edge
    bool complete = true;             ///< false: there are too many parts, and the smaller ones were skipped
};

/// Hidden is what a patch that faces the reader lies before. A crease is an edge where a closed surface turns by over 23 degrees.
SeenEdges seen_edges(const std::vector<ModelPart>& parts, const ViewPlane& view, double touching);

/// Where a part is cut by the plane that lies `at` mm towards the reader: sides that run so that what is solid is on the same
/// hand. Of a closed part they are closed rings.
std::vector<DrawnSide> cut_sides(const ModelPart& part, const ViewPlane& view, double at);

/// mm to the right, down and towards the reader, of a place.
inline Point flat_place(const Point3& at, const ViewPlane& view) { return {dot(at, view.right), dot(at, view.down)}; }

}  // namespace tactics
