// SPDX-License-Identifier: Apache-2.0
// A sheet without thickness that is there twice, so that it can be seen from both sides.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/solid/touching_solids.h"
#include "tactics/solid/welded_surface.h"

namespace tactics {

/// Two planes that lie on each other and look in opposite directions.
bool are_backs(const Point3& one, const Point3& other);

/// A plane looks up rather than down, to the front rather than to the back, to the right rather than to the left.
bool looks_at_reader(const Point3& area);

/// Of two such planes with the same border, however each is cut into faces, that of a solid stays, else the one that looks at the
/// reader; those of two solids stay. Likewise of two such faces. `solid`, of each face, stays so. Gives how many faces went.
std::size_t drop_backs(WeldedSurface& surface, std::vector<SolidOfFace>& solid);

}  // namespace tactics
