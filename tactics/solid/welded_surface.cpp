// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/welded_surface.h"

#include "tactics/geometry/triangulate.h"

namespace tactics {

Point3 doubled_area(const std::vector<Point3>& corners, const CornerRing& ring) {
    return doubled_area(ring.size(), [&](std::size_t i) { return corners[ring[i]]; });
}

std::vector<Point3> doubled_areas(const WeldedSurface& surface) {
    std::vector<Point3> areas;
    areas.reserve(surface.faces.size());
    for (const CornerRing& ring : surface.faces) areas.push_back(doubled_area(surface.corners, ring));
    return areas;
}

std::vector<FaceSide> sides_of(const std::vector<CornerRing>& faces) {
    std::vector<FaceSide> sides;
    for (std::uint32_t face = 0; face < faces.size(); ++face)
        for (std::size_t i = 0; i < faces[face].size(); ++i)
            sides.push_back({faces[face][i], faces[face][(i + 1) % faces[face].size()], face});
    std::stable_sort(sides.begin(), sides.end(),
                     [](const FaceSide& a, const FaceSide& b) { return key_of_side(a.from, a.to) < key_of_side(b.from, b.to); });
    return sides;
}

}  // namespace tactics
