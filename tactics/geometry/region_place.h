// SPDX-License-Identifier: Apache-2.0
// A point at which a finger is certainly on a thing.
#pragma once

#include "tactics/drawing.h"

namespace tactics {

/// Of places on a grid of 11 x 11 over its box, the one within that is farthest from its border; a corner of it if none is
/// within. It must have a ring.
Point place_in(const Region& region);

}  // namespace tactics
