// SPDX-License-Identifier: Apache-2.0
// A scene in the workspace of an arm.
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

/// The visible lines of a model without width or depth.
struct SheetOutline {
    PlotCurve onto;   ///< in x and y
    PlotCurve along;  ///< in x and height
};

struct ArmScene {
    Plot plot;                                  ///< the scene in values, for speech, drawings and the expected findings of a hand
    PlotFrame frame;                            ///< position of these values under the finger
    Mounting mounting;                          ///< position of the frame in the workspace
    ForceLaw law;                               ///< of firm things
    double resolution;                          ///< mm that the arm resolves
    std::optional<PlotSurface> contoured = {};  ///< the surface whose contours its curves are: a chart draws them with their
                                                ///< heights
    bool solid = false;                         ///< a relief or a model, in which a hand finds neither curves nor points
    std::unique_ptr<const ReliefSurface> relief = {};  ///< surface of the scene; null for a plot or a model
    std::unique_ptr<Scene> scene = {};
    std::optional<SheetOutline> sheet = {};
};

}  // namespace tactics
