// SPDX-License-Identifier: Apache-2.0
// Which of many rectangles are the bars of a chart: they stand on one base, beside each other or one on the other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tactics/geometry/box.h"

namespace tactics {

/// In any unit, y down. A blank one looks like the ground.
struct BarRectangle {
    Box box;
    bool blank = false;
};

/// How far the middles of sides that are one may be apart, and the end of a bar from the foot of one that stands on it.
struct BarSlack {
    double touch = 0, stacked = 0;
};

/// A bar as if it stood: lying ones are turned so that they do. Its foot is lower than its top, also where it hangs.
struct StandingBar {
    double left = 0, right = 0, top = 0, foot = 0;
    std::size_t number = 0;  ///< of the rectangle
    bool blank = false;

    double width() const { return right - left; }
    double area() const { return (right - left) * (foot - top); }
};
Box as_it_lies(const StandingBar& bar, bool lying);

struct BarsOnBase {
    std::vector<StandingBar> bars;
    double base = 0;  ///< of the standing bars
    bool lying = false;

    /// Where they stand: x if they lie, else y.
    double place() const { return lying ? -base : base; }
};

/// On the base on which most is filled, level or upright: those that stand there or hang from it, and those on them. None unless
/// at least three that are filled stand there.
BarsOnBase bars_on_base(std::span<const BarRectangle> rectangles, const BarSlack& slack);

/// About as wide, and its foot is the other's top: the outermost line of a hatch may be taken for a side.
bool is_stacked_on(const StandingBar& upper, const StandingBar& lower, const BarSlack& slack);

/// Boxes of one size in a row are those of a diagram, and cells in rows those of a table: most end where those beside them do.
bool stand_as_boxes(std::span<const StandingBar> bars, double touch);

/// Numbers of bars that stand on each other, from the base on; or if none do, those beside each other with less than half of
/// their width between.
std::vector<std::vector<std::size_t>> bar_groups(const BarsOnBase& found, const BarSlack& slack);

}  // namespace tactics
