// SPDX-License-Identifier: Apache-2.0
// Braille that a file holds as mere dots.
#pragma once

#include <vector>

#include "tactics/readers/svg/found_page.h"

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

/// Of a figure, such as a page of ours that another program printed into a PDF: round areas that are the dots of words in braille
/// are taken out and become lines of braille, in mm of the file. Points of a plot stay: they stand in no cells, or in too few.
void take_braille_of_figure(FoundPage& figure);

/// Is this ring a disc of the size of a braille dot?
bool is_braille_dot(const std::vector<Point>& ring, Disc& disc);

}  // namespace tactics
