// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/arm_plot.h"

#include <algorithm>
#include <utility>

#include "cli/verbs/play_arm_flags.h"
#include "cli/verbs/play_frame.h"
#include "tactics/haptics/scenes/plot_part.h"

namespace tactics {

namespace {

constexpr double kAspect = 1.5;  // of the field, where the workspace has room
constexpr double kShare = 0.5;   // of what the arm can be stiff: two parts may push the same way

}  // namespace

ArmScene plot_on_arm(Plot plot, const Given& given, const ArmFile& file, std::vector<Phrase>& told) {
    const ArmSettings& arm = file.arm;
    const std::vector<const PlotPart*> parts = parts_of(given);
    // A surface lies on a table, as a relief does; curves are on a wall, as in the paper.
    const ScenePlane plane = plane_of(given).value_or(plot.surfaces.empty() ? kUpright : kFlat);
    const MountedField field = mount(plane, {arm.width, arm.height, arm.depth}, kAspect, kArmMargin);
    check_field({field.width, field.width});
    const PlotFrame frame = frame_of(plot, field, room_over(field, arm));
    ArmScene scene{std::move(plot), frame, field.mounting, arm_law_of(given, file, kShare), std::max(arm.resolution, 0.01)};
    std::vector<Phrase> left_out;
    scene.scene = plot_scene({scene.plot, frame, scene.law, fixture_of(given), scene.resolution}, parts, left_out);
    told.insert(told.end(), left_out.begin(), left_out.end());
    return scene;
}

}  // namespace tactics
