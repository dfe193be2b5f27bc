// SPDX-License-Identifier: Apache-2.0
// Lines thinner than what an edge detector sees as two edges.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Puts the middles of lines up to `widest` pixels wide into a thinned map, with their contrast as strength, in place of the
/// edges within `beside` pixels of them.
void add_thin_lines(EdgeMap& edges, const Image& picture, double widest, double beside);

}  // namespace tactics
