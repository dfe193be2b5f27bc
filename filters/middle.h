// SPDX-License-Identifier: Apache-2.0
// Thinned lines moved to the middle of their ink.
#pragma once

#include "filters/paths.h"

namespace tactics {

/// Thinning takes whole pixels, so that its line lies up to a pixel beside the middle of wide ink, the same way all along.
/// Each point (in pixels) goes to the middle between the ink's two sides across the line, as far as the ink is a line there.
/// At an end of ink the thinned line bends into a corner of it: there it goes straight on as far as it went.
void move_to_middle(PixelPath& path, const Skeleton& skeleton);

}  // namespace tactics
