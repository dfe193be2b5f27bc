// SPDX-License-Identifier: Apache-2.0
// Curves beside darker ones that are so pale that one cut between ink and ground would lose them.
#pragma once

#include <array>

#include "tactics/image.h"

namespace tactics {

/// Makes them as dark as the ink. They are long, thin and nowhere beside darker ink; level and upright lines are none, as most
/// are frames and grids. A picture whose ground is not clean, such as a scan, stays as it is.
void deepen_pale_curves(Image& picture, const Image& ink, const std::array<int, 3>& ground);

}  // namespace tactics
