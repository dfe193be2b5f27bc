// SPDX-License-Identifier: Apache-2.0
// Ink as lines and areas of a drawing.
#pragma once

#include "filters/outline.h"
#include "tactics/drawing.h"

namespace tactics {

/// In mm.
struct TraceLimits {
    double shortest = 2;  ///< shorter lines and smaller dots are left out, but half of it is enough between two lines
    double spur = 2;      ///< shorter side branches are cut off
    double bridge = 2;    ///< ends that point at each other over a gap up to this are joined
};

/// A piece of ink, filled; rings of a lesser extent than `shortest` mm are left out. `scale`: mm of a pixel.
void add_area(Drawing& drawing, const Outline& outline, double scale, double shortest);

/// The middle of each line of the ink, with dots kept as areas. `edges`: the thinned map that the ink is of, and `unthinned` that
/// before, whose ridges the lines follow; nullptr for ink of a picture.
void add_lines(Drawing& drawing, InkMap ink, const EdgeMap* edges, const EdgeMap* unthinned, double scale,
               const TraceLimits& limits);

}  // namespace tactics
