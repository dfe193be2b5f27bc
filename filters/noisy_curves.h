// SPDX-License-Identifier: Apache-2.0
// Curves of a drawn chart that go up and down faster than a finger can follow.
#pragma once

#include <array>
#include <vector>

#include "filters/components.h"
#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// In pixels.
struct NoisyCurve {
    std::vector<Point> course;                 ///< from left to right, as fine as a finger can follow
    std::vector<std::array<Point, 2>> spikes;  ///< from the course to where it stands far out
    std::vector<Run> ink;
};

/// Curves of one colour from left to right, one place above each other, that turn back again within a finger's gap; drawn through
/// the middle value of each stretch, as curves of tables are (chart_curves.h). The picture has its size in mm.
std::vector<NoisyCurve> noisy_curves_in(const Image& picture);

}  // namespace tactics
