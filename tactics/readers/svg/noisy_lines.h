// SPDX-License-Identifier: Apache-2.0
// Curves of a figure that go up and down faster than a finger can follow, as time series do.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

struct NoisyLine {
    std::vector<Point> course;                 ///< mm, through the middle of its noise, as fine as a finger can follow
    std::vector<std::array<Point, 2>> spikes;  ///< from the course to where it stands far out
};

/// Of an open line, in mm on the page; nothing unless it is a long one from left to right or back, and noisy all along.
std::optional<NoisyLine> noisy_line(const std::vector<Point>& line);

}  // namespace tactics
