// SPDX-License-Identifier: Apache-2.0
// Bars of a chart in a picture, as they are felt: straight outlines, of two that are close one line, and a filling for each kind.
#pragma once

#include <vector>

#include "filters/inked_bars.h"
#include "tactics/drawing.h"

namespace tactics {

struct FeltBars {
    std::vector<Stroke> strokes;  ///< mm
    std::vector<Area> areas;
};

/// `mm`: of a pixel. Nothing where bars are so thin that the lines of their sides would be one to a finger. Wide ones have
/// textures. What is narrower than a texture needs is told apart by rungs from side to side, a black surface and a line along its
/// middle; the palest kind is blank. Where there are more kinds than fillings all are blank.
FeltBars felt_bars(const InkedBars& bars, double mm);

}  // namespace tactics
