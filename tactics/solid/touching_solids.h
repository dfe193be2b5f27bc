// SPDX-License-Identifier: Apache-2.0
// Closed solids that touch each other in one surface, such as the top and the legs of a table.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/welded_surface.h"

namespace tactics {

inline constexpr std::uint32_t kNoSolid = ~0u;

/// The solid that a face is of, by the number of one of its faces. kNoSolid: of none that is closed, has a volume and looks
/// outwards.
struct SolidOfFace {
    std::uint32_t own = kNoSolid;
    /// With all that share an edge with it from end to end, as cubes in a row do. Those that touch otherwise are several.
    std::uint32_t joined = kNoSolid;
};

/// Of each face. The same however faces are cut.
std::vector<SolidOfFace> touching_solids(const WeldedSurface& surface);

/// Faces of solids that are not joined have no corner in common from there on.
void set_apart(WeldedSurface& surface, const std::vector<SolidOfFace>& solid);

}  // namespace tactics
