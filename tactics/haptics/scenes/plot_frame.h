// SPDX-License-Identifier: Apache-2.0
// The positions of a plot's values under a finger: the paper's transform from data to device coordinates ("Design of a Haptic
// Graphing System", section Development).
#pragma once

#include <vector>

#include "tactics/page.h"
#include "tactics/plot.h"
#include "tactics/point3.h"

namespace tactics {

/// An axis as felt: its ends and its marked values, in the plot's own units.
struct FeltAxis {
    double low = 0, high = 1;
    bool logarithmic = false;
    std::vector<double> ticks = {};

    double share_of(double value) const noexcept;  ///< 0 at low, 1 at high
    double value_at(double share) const noexcept;
};

/// Converts values to mm and back. The field of a plot lies in the plane z = 0: x to the right from 0 to the width, y downwards
/// from 0 at the highest value to the height at the lowest, z towards the finger from 0 to the depth.
struct PlotFrame {
    FeltAxis x, y, z;
    double width = 100, height = 80, depth = 0;  ///< mm

    double across(double value) const noexcept { return width * x.share_of(value); }
    double down(double value) const noexcept { return height * (1 - y.share_of(value)); }
    Point3 place(double at_x, double at_y, double at_z = 0) const noexcept {
        return {across(at_x), down(at_y), depth > 0 ? depth * z.share_of(at_z) : 0};
    }
    Point3 values(const Point3& place) const noexcept {
        return {x.value_at(place.x / width), y.value_at(1 - place.y / height), depth > 0 ? z.value_at(place.z / depth) : 0};
    }
};

/// The curves of a plot as lines in the plane z = 0, mm, for a device of that resolution: points that change the line by less are
/// left out, because the device could not show them. Steps and bars have their vertical sides.
struct FeltLines {
    std::vector<std::vector<Point>> lines;
    std::vector<std::size_t> curve;  ///< for each line, the index of its curve in the plot; a gap begins another line of the same
                                     ///< curve
    std::size_t points = 0;          ///< of the curves
    std::size_t kept = 0;            ///< of the lines
};
FeltLines felt_lines(const Plot& plot, const PlotFrame& frame, double resolution);

}  // namespace tactics
