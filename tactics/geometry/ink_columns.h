// SPDX-License-Identifier: Apache-2.0
// A curve as the columns of its ink, and what of it a finger can follow.
#pragma once

#include <array>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// Of a curve that has one place above each other, in pixels.
struct InkColumn {
    int x = 0, top = 0, bottom = 0;  ///< the first pixel and the last
    int ink = 0;                     ///< pixels between them

    double middle() const { return (top + bottom + 1) / 2.0; }
};

/// Whether both sides of the ink turn within a finger's gap, or so often that small turns hide the large ones, all along. Error
/// bars and markers, which go as far up as down, are none of this, nor are waves.
bool is_noise(const std::vector<InkColumn>& columns, double mm);

/// The middle value of each stretch, as for curves of tables (filters/chart_curves.h), but a stretch grows only where the line
/// would come nearer to itself than a finger's gap.
std::vector<Point> followable(const std::vector<InkColumn>& columns, double mm);

/// Where that line is, at the middle of each column; level before its first point and behind its last.
std::vector<double> heights_along(const std::vector<Point>& line, const std::vector<InkColumn>& columns);

/// Peaks that stand far out of the noise, from that line to their tips, with a finger's gap between them, the highest first.
std::vector<std::array<Point, 2>> spikes_of(const std::vector<InkColumn>& columns, const std::vector<Point>& line, double mm);

}  // namespace tactics
