// SPDX-License-Identifier: Apache-2.0
// The shape of a surface in a word, as two sections through its middle tell it: felt ones or true ones.
#pragma once

#include <string_view>
#include <vector>

#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A section from one side to the other.
struct Section {
    std::vector<Point> heights;  ///< x: share of the section, from 0 to 1 and rising; y: height there
    std::vector<double> bare;    ///< shares where there is no ground
};

/// "level", "slope" (either way), "step" (most of the way at one edge, or within a third of the section and with level ground on
/// either side), "steps" (most of the way at two or three edges, or levels one above the other), "hump", "dip", "waves" (it turns
/// more than once) or "hole"; empty: unknown, as a stretch is missing. What is lower than a tenth of `whole`, the range of all
/// heights, is level, and so is what is lower than a seventh of the section's own range: it turns only where it comes back that
/// far. Both shares are ours. The outer tenths are left out, as a hand slips off the sides of a solid.
std::string_view course_of(const Section& section, double whole);

/// "level", "slope", "step", "steps", "waves", "hole", "hill", "bowl", "saddle", "ridge" or "valley"; empty: two courses that no
/// one word has.
std::string_view shape_of(std::string_view across, std::string_view down);

/// "a slope", "level ground".
Phrase spoken_shape(std::string_view shape_or_course);

}  // namespace tactics
