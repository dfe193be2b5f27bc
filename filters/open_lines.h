// SPDX-License-Identifier: Apache-2.0
// Lines that end freely, put into a drawing of whole outlines.
#pragma once

#include <span>

#include "tactics/drawing.h"
#include "tactics/region_tree.h"

namespace tactics {

struct OpenLines {
    double gap = 4.4;      ///< mm: lines run no nearer beside each other, nor beside the frame
    double bend = 1.4;     ///< mm: the deviation of the Gaussian along each
    double shortest = 16;  ///< mm; half of that where both ends are attached
    float least = 0;       ///< strength, 0 to 255
    double most = 0;       ///< mm of line at most
    bool attached = true;  ///< each begins or ends on a drawn line or at the frame, and is extended there; else it is free
};

/// Adds what of `lines` (pixels of the tree that the drawing was made from) is apart from what is drawn, thin, the longest and
/// surest first.
void add_open_lines(Drawing& drawing, std::span<const RegionLine> lines, double mm_per_pixel, const OpenLines& wish);

}  // namespace tactics
