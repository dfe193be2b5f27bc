// SPDX-License-Identifier: Apache-2.0
// The position of a plot in the workspace of an arm.
#pragma once

#include <string>

#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/plot.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The axes that a plot has under a finger, in a field with `room` mm over it.
PlotFrame frame_of(const Plot& plot, const MountedField& field, double room);

/// mm of free workspace around the plot, for pushing at an axis and leaving a curve.
inline constexpr double kArmMargin = 8;
inline constexpr double kLeastField = 30;  ///< mm; on a smaller field a hand finds nothing

/// mm that the workspace has over the plane, on the finger's side, less the margin.
double room_over(const MountedField& field, const ArmSettings& arm);

/// The width and the height of the plane that the workspace has, less the margin, mm.
Point most_of_plane(const ScenePlane& plane, const ArmSettings& arm);

/// Throws Error(usage): a side is under kLeastField.
void check_field(Point size);

/// The scale at which a box just fits.
struct FittedBox {
    Mounting axes;     ///< its origin is the point of the plane nearest to the middle of the workspace
    double scale = 0;  ///< infinite for a box without a size
};
/// A box of that size (mm) with its middle over that place; `under` of its z lies below the plane. Throws Error(usage) if the
/// plane leaves no room.
FittedBox fit_box(const ScenePlane& plane, const ArmSettings& arm, const Point3& size, double under);
/// The upper left corner of its lower side in that case; `size` is the felt size.
Mounting mounting_of(const FittedBox& box, const Point3& size, double under);
/// An axis from `low` to `high`, with that many mm per unit; without ticks.
PlotFrame frame_of_box(const Point3& low, const Point3& high, double mm_each);
/// "is 300 x 200 x 12 mm, of which 0.4 times is felt: 120 x 80 x 4.8 mm".
Phrase told_scale(const Point3& size, double scale);

/// "scene":{...}: how large it is felt, which values its sides are, how many mm one of them has, and its corner (at the least x
/// and the largest y) and axes in those of the workspace.
std::string frame_json(const PlotFrame& frame, const Mounting& mounting);

}  // namespace tactics
