// SPDX-License-Identifier: Apache-2.0
// Surfaces that a file has twice in one place, as where it gives each face a front and a back.
#pragma once

#include <cstddef>

#include "tactics/solid/welded.h"

namespace tactics {

/// Of faces that lie over each other in two layers which cover the same place, however each is divided, one layer is left out:
/// that which looks towards the middle of the surface. Gives the number of faces left out.
std::size_t drop_backs(WeldedSurface& surface);

}  // namespace tactics
