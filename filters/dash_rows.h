// SPDX-License-Identifier: Apache-2.0
// Dashed and dotted lines of a picture of ink: rows of small thin pieces with gaps that are alike.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "filters/components.h"
#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// What a piece of ink may be to be a dash, in pixels.
struct DashLimits {
    double longest = 0, widest = 0, gap = 0;
};

/// A mark that hides what is under it, in pixels: a dashed line that leads to it goes on behind it.
struct HidingMark {
    Point middle;
    double radius = 0;
};

/// The marks of a dashed line, as far as a finger can tell them apart.
enum class DashKind : std::uint8_t { dashes, dots, dashes_and_dots };

/// A line of at least four dashes, in pixels; or of two or three that lead from one thing to another, as whiskers of boxes do.
struct DashRow {
    std::vector<Point> points;  ///< both ends of each dash, one behind the other; the outermost on what they stop close before
    double width = 0;           ///< of most of its dashes
    double longest = 0;         ///< of most of its long dashes, with their ends
    DashKind kind = DashKind::dashes;
    std::vector<Run> ink;
    bool leads = false;  ///< the second
    int met = 0;         ///< how many of its ends stop close before something
};

/// Level or upright from end to end, and which of both.
std::optional<bool> is_level(const DashRow& row);

/// Straight, and of clear dashes.
bool is_straight(const DashRow& row);

/// The middle ones of a dashed line's marks and gaps, in pixels.
struct DashLengths {
    double mark = 0, gap = 0;
};
DashLengths lengths_of(const DashRow& row);
double middle_length(std::vector<double> lengths);  ///< of one at least

/// Of several marks at one distance, with little more than their length between them: no points of a plot.
bool is_dense(const DashRow& row);

/// What a dashed line's marks are, whose lengths these are, in widths of the line. Few may be cut short by what they cross.
DashKind dash_kind(std::vector<double> lengths);

/// In `ink`, what is darker than 128. A line may turn by up to 30 degrees from dash to dash, has one colour in `picture`, and
/// goes on behind what it crosses. Of more than 4000 pieces that could be dashes none is: it is a pattern or noise.
std::vector<DashRow> dash_rows_in(const Image& ink, const Image& picture, const DashLimits& limits,
                                  const std::vector<HidingMark>& marks = {});

}  // namespace tactics
