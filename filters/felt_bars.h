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

/// `mm`: of a pixel. Bars too thin for a finger become wider where there is room between their groups; nothing where there is
/// none. Wide ones have textures. What is narrower than a texture needs is told apart by rungs from side to side, close or far
/// apart, a line along its middle, and a black surface; the palest kind is blank. Where there are more kinds than fillings all
/// are blank.
FeltBars felt_bars(const InkedBars& bars, double mm);

}  // namespace tactics
