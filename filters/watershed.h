// SPDX-License-Identifier: Apache-2.0
// The finest regions of a contour map: its basins.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// The basin of each pixel, numbered from 0: the map is flooded from its minima, and where two floods meet is a border (L.
/// Vincent and P. Soille 1991; in order of height by F. Meyer 1994). Basins hang together by the sides of pixels and cover the
/// picture. `map` is not thinned: its strength falls off from the contours to both sides.
std::vector<std::uint32_t> basins_of(const EdgeMap& map);

}  // namespace tactics
