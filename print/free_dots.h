// SPDX-License-Identifier: Apache-2.0
// From a page to freely placed dots, for machines without a raster.
#pragma once

#include <vector>

#include "tactics/page.h"

namespace tactics {

/// Dots closer than this feel like one dot and tear the paper: the diameter of a Marburg Medium dot, mm.
inline constexpr double kLeastBetweenDots = 1.6;

/// Everything tactile on a page as dots, from top to bottom:
/// - braille where its standard places it;
/// - a line as dots that stand evenly on it, about `spacing` mm from each other, with a dot at each end and at each sharp turn;
///   where it comes within kLeastBetweenDots of dots that are there already (a crossing, a junction), those stand for its own;
/// - an area as its outline, filled with rows of dots; a picture as dots where it is black (raise_dots).
std::vector<Point> free_dots(const Page& page, double spacing);

}  // namespace tactics
