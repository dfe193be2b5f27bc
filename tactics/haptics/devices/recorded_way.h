// SPDX-License-Identifier: Apache-2.0
// The recorded path of a finger: moments, with straight lines between them.
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
    /// At least one moment, in order.
    RecordedWay(std::vector<WayMoment> moments, bool has_height) : moments_(std::move(moments)), has_height_(has_height) {}
    bool has_height() const noexcept { return has_height_; }  ///< else z is 0
    double end() const noexcept { return moments_.back().time; }
    /// Call it with ascending times: a time before the last one is assumed to lie in the same piece.
    Point3 at(double time) noexcept;

private:
    std::vector<WayMoment> moments_;
    bool has_height_;
    std::size_t next_ = 0;
};

/// Lines of "time_s,x_mm,y_mm", or in the order of a header line with these names; a height is z_mm or, as in play --csv,
/// finger_mm; other columns are ignored. Or a recording in the container (tactics/coding). Throws Error(failed) at `name` and
/// line for a value that is not a number or is beyond 1e7 s or 1e5 mm, time that goes back, two heights, over 10 million lines,
/// or fewer than two.
RecordedWay read_way(std::string_view csv, const std::string& name);

}  // namespace tactics
