// SPDX-License-Identifier: Apache-2.0
// A point at which a finger is certainly on a thing.
#pragma once

#include "tactics/drawing.h"

namespace tactics {

/// Of the points of an 11 x 11 grid over its box, the inner one farthest from its border; a corner of it if no point is inside.
/// It must have a ring.
Point place_in(const Region& region);

}  // namespace tactics
