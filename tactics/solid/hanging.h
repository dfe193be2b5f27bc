// SPDX-License-Identifier: Apache-2.0
// Things under a face that hides them (the column of a café table, the thick legs of a bench, a cupboard under its top) are laid
// out over the border of that face, like slender legs: M. Kurze, CHI 1997, step 4, for things too thick to be lines.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/panel.h"
#include "tactics/solid/space_grid.h"

namespace tactics {

/// Adds what each hidden part looks like from the sides of the face over it that are nearest, hinged to that side, and what hangs
/// on such a part below it, hinged to the part. `near` has the boxes of all parts.
void add_hanging(Panels& panels, const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing,
                 const SpaceGrid& near, const ViewPlane& view);

}  // namespace tactics
