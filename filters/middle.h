// SPDX-License-Identifier: Apache-2.0
// Moves thinned lines to the middle of their ink.
#pragma once

#include "filters/paths.h"

namespace tactics {

/// Thinning removes whole pixels, so its line lies up to a pixel beside the middle of wide ink, consistently to one side. Each
/// point (in pixels) moves to the middle between the two sides of the ink, wherever the ink is a line. At an end of ink the
/// thinned line bends into a corner; there it is replaced by a straight continuation of the same length.
void move_to_middle(PixelPath& path, const Skeleton& skeleton);

}  // namespace tactics
