// SPDX-License-Identifier: Apache-2.0
// The way of a finger that was recorded: moments, between which it is taken to be straight.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/point3.h"

namespace tactics {

struct WayMoment {
    double time = 0;  ///< s from the first
    Point3 at;        ///< mm
};

class RecordedWay {
public:
    /// At least one moment, in their order.
    RecordedWay(std::vector<WayMoment> moments, bool has_height) : moments_(std::move(moments)), has_height_(has_height) {}
    bool has_height() const noexcept { return has_height_; }  ///< else z is 0
    double end() const noexcept { return moments_.back().time; }
    /// Asked forwards: a time before the last that was asked for is taken to lie in the same piece.
    Point3 at(double time) noexcept;

private:
    std::vector<WayMoment> moments_;
    bool has_height_;
    std::size_t next_ = 0;
};

/// "time_s,x_mm,y_mm" a line, or in the order of a header line with these names; a height is z_mm or, as play --csv calls it,
/// finger_mm; other columns are passed over. Or a recording of the container (tactics/coding). Throws Error(failed) at `name` and
/// line: not a number, beyond 1e7 s or 1e5 mm, time that goes back, two heights, over 10 million lines, under two.
RecordedWay read_way(std::string_view csv, const std::string& name);

}  // namespace tactics
