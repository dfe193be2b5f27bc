// SPDX-License-Identifier: Apache-2.0
// Ink that is no line: the filled dots of maps and diagrams, of which thinning leaves a pixel.
#pragma once

#include "filters/outline.h"
#include "tactics/geometry/skeleton.h"

namespace tactics {

/// Removes the piece of ink around that pixel from the thinned picture, and returns its outline.
Outline take_piece(Skeleton& skeleton, std::uint32_t pixel);

}  // namespace tactics
