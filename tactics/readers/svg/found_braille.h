// SPDX-License-Identifier: Apache-2.0
// Braille that a file holds as mere dots.
#pragma once

#include <vector>

#include "tactics/page.h"

namespace tactics {

struct Disc {
    Point middle;
    double diameter = 0;
};

/// Dots as small as braille's that stand as cells do become lines of braille of the page, and its cell and dot size are what
/// they measure; those that fit no cell are left.
std::vector<Disc> take_braille(std::vector<Disc> discs, Page& page);

/// The same, and those that fit none become dots of the page.
void settle_discs(std::vector<Disc> discs, Page& page);

/// Is this ring a disc of the size of a braille dot?
bool is_braille_dot(const std::vector<Point>& ring, Disc& disc);

}  // namespace tactics
