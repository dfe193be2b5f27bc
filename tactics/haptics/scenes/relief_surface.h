// SPDX-License-Identifier: Apache-2.0
// A height map as a finger meets it: a surface without gaps, and the same seen by a fingertip that is no point.
#pragma once

#include "tactics/drawing.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

/// Grey dilation of the map by a ball: where the middle of a fingertip of that radius (mm) can be, less the radius. Made once,
/// so a radius costs nothing per update; making it takes (radius / pitch)^2 as long. The ball touches
/// samples only: on a slope it falls short by about pitch^2 / (4 radius) at most, on level ground, at tops and at steps by
/// nothing. Radius 0: the map itself; otherwise holes are filled first, as ReliefSurface fills them.
HeightMap dilated(const HeightMap& map, double radius);

/// A height map made ready to be felt. Holes (NaN, infinite) are filled from their neighbours when it is made, a map of holes
/// only with 0; maps of one sample, one row or one column work. A map without samples or without a pitch is a std::logic_error.
class ReliefSurface {
public:
    explicit ReliefSurface(HeightMap map);

    double height(Point at)
        const noexcept;  ///< mm, bilinear between samples; beside the map as at its edge; NaN positions: the lowest height
    Point slope(Point at)
        const noexcept;  ///< mm per mm, of the same surface; 0 for NaN positions; between two squares, that of the second
    double lowest() const noexcept { return lowest_; }
    double highest() const noexcept { return highest_; }
    const HeightMap& map() const noexcept { return map_; }  ///< without holes

private:
    // The four samples around a place, and how far it is on the way from the first to the others.
    struct Square {
        const float* first;
        double across, down;
    };
    Square square_at(double u, double v) const noexcept;

    HeightMap map_;
    double per_mm_ = 1;  // samples
    double last_column_ = 0, last_row_ = 0;
    int right_ = 0, below_ = 0;  // from a sample to its neighbours; 0 where there are none
    int last_square_column_ = 0, last_square_row_ = 0;
    double lowest_ = 0, highest_ = 0;
};

}  // namespace tactics
