// SPDX-License-Identifier: Apache-2.0
// A height map prepared for touch: a surface without gaps, also for a fingertip with a radius.
#pragma once

#include "tactics/drawing.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

/// Grey dilation of the map by a ball: the lowest positions of the middle of a fingertip of that radius (mm), minus the radius.
/// It is made once, so a radius costs nothing per update; the preparation takes (radius / pitch)^2 times as long. The ball
/// touches only samples: on a slope the result is too low by about pitch^2 / (4 radius) at most; on level ground, at tops and at
/// steps it is exact. Radius 0: the map itself; otherwise holes are filled first, as ReliefSurface does.
HeightMap dilated(const HeightMap& map, double radius);

/// A height map prepared for touch. Its construction fills holes (NaN, infinite) from their neighbours, and a map of holes only
/// with 0; maps of one sample, one row or one column work. Throws std::logic_error for a map without samples or without a pitch.
class ReliefSurface {
public:
    explicit ReliefSurface(HeightMap map);

    double height(Point at)
        const noexcept;  ///< mm, bilinear between samples; outside the map as at its edge; for NaN positions, the lowest height
    Point slope(Point at)
        const noexcept;  ///< slope of the same surface, mm per mm; 0 for NaN positions; between two squares, that of the second
    double lowest() const noexcept { return lowest_; }
    double highest() const noexcept { return highest_; }
    const HeightMap& map() const noexcept { return map_; }  ///< without holes

private:
    // The four samples around a place, and its fractional position between them.
    struct Square {
        const float* first;
        double across, down;
    };
    Square square_at(double u, double v) const noexcept;

    HeightMap map_;
    double per_mm_ = 1;  // samples
    double last_column_ = 0, last_row_ = 0;
    int right_ = 0, below_ = 0;  // offsets from a sample to its neighbours; 0 if there are none
    int last_square_column_ = 0, last_square_row_ = 0;
    double lowest_ = 0, highest_ = 0;
};

}  // namespace tactics
