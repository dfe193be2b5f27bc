// SPDX-License-Identifier: Apache-2.0
// What is felt on an arm, as it stands in the arm's workspace.
#pragma once

#include <memory>
#include <optional>

#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/scenes/force_law.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/scenes/relief_surface.h"
#include "tactics/haptics/scenes/scene.h"
#include "tactics/plot.h"

namespace tactics {

/// A model without a width or a depth: what there is to see of it.
struct SheetOutline {
    PlotCurve onto;   ///< in x and y
    PlotCurve along;  ///< in x and height
};

struct ArmScene {
    Plot plot;                                  ///< it in values: what is spoken of it, drawn of it, and what a hand should find
    PlotFrame frame;                            ///< where these are under the finger
    Mounting mounting;                          ///< where that is in the workspace
    ForceLaw law;                               ///< of what is firm
    double resolution;                          ///< mm that the arm tells apart
    std::optional<PlotSurface> contoured = {};  ///< that its curves are the contours of: a chart draws those with their heights
    bool solid = false;                         ///< a relief or a model, of which a hand finds neither curves nor points
    std::unique_ptr<const ReliefSurface> relief = {};  ///< that the scene feels; nothing of a plot or a model
    std::unique_ptr<Scene> scene = {};
    std::optional<SheetOutline> sheet = {};
};

}  // namespace tactics
