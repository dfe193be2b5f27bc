// SPDX-License-Identifier: Apache-2.0
// Where a plot is in the workspace of an arm.
#pragma once

#include <string>

#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/plot.h"

namespace tactics {

/// The axes that a plot has under a finger, in a field with `room` mm over it.
PlotFrame frame_of(const Plot& plot, const MountedField& field, double room);

/// mm of the workspace round what is felt: an axis is pushed at, and a curve left.
inline constexpr double kArmMargin = 8;
inline constexpr double kLeastField = 30;  ///< mm; on less nothing is found

/// mm that the workspace has over the plane, on the finger's side, less the margin.
double room_over(const MountedField& field, const ArmSettings& arm);

/// The width and the height of the plane that the workspace has, less the margin, mm.
Point most_of_plane(const ScenePlane& plane, const ArmSettings& arm);

/// Throws Error(usage): a side is under kLeastField.
void check_field(Point size);

/// How many times as large a box is where it just fits.
struct FittedBox {
    Mounting axes;     ///< its origin is the place of the plane that is nearest to the middle of the workspace
    double scale = 0;  ///< infinite for a box without a size
};
/// A box of that size (mm) whose middle is over that place: `under` of its z is under the plane. Throws Error(usage) where the
/// plane leaves no room.
FittedBox fit_box(const ScenePlane& plane, const ArmSettings& arm, const Point3& size, double under);
/// Where its upper left corner of the lower side is, then; `size` is as it is felt.
Mounting mounting_of(const FittedBox& box, const Point3& size, double under);
/// From `low` to `high` in values, which are felt so many mm each; without ticks.
PlotFrame frame_of_box(const Point3& low, const Point3& high, double mm_each);
/// "is 300 x 200 x 12 mm, of which 0.4 times is felt: 120 x 80 x 4.8 mm".
std::string told_scale(const Point3& size, double scale);

/// "scene":{...}: how large it is felt, which values its sides are, how many mm one of them has, and its corner (at the least x
/// and the largest y) and axes in those of the workspace.
std::string frame_json(const PlotFrame& frame, const Mounting& mounting);

}  // namespace tactics
