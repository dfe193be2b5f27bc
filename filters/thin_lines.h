// SPDX-License-Identifier: Apache-2.0
// Lines thinner than what an edge detector sees as two edges.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Puts the middles of lines up to `widest` pixels wide into a thinned map, with their contrast as strength, in place of the
/// edges within `beside` pixels of them. An edge that met such a line, as the side of a bar meets an axis, is led on to its
/// middle. The map has the directions of its edges.
void add_thin_lines(EdgeMap& edges, const Image& picture, double widest, double beside);

}  // namespace tactics
