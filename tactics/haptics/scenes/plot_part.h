// SPDX-License-Identifier: Apache-2.0
// What of a plot can be felt on its own. The parts are in a list (list.inc), one a line.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tactics/haptics/scenes/fixture.h"
#include "tactics/haptics/scenes/force_law.h"
#include "tactics/haptics/scenes/parts_scene.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/plot.h"

namespace tactics {

/// What is made ready to be felt, and how firmly.
struct PlotFeel {
    const Plot& plot;  ///< needed only while parts are made
    PlotFrame frame;
    ForceLaw law;               ///< of everything firm; no part is stiffer
    FixtureSettings fixture;    ///< of the curves; softened until it rises no steeper than the law
    double resolution = 0.055;  ///< mm that the device tells apart
};

struct PlotPart {
    std::string_view name = {};  ///< "curves", as it is typed
    std::string_view what = {};
    /// nullptr: the plot has none of it. `told` is told what was left out, a line each.
    std::unique_ptr<Scene> (*make)(const PlotFeel& feel, std::vector<std::string>& told) = nullptr;
};

std::span<const PlotPart* const> plot_parts();

/// All parts of those names, in a box that wakes them: open towards walls and axes, and as far beyond the field as anything of it
/// is felt elsewhere.
std::unique_ptr<Scene> plot_scene(const PlotFeel& feel, const std::vector<const PlotPart*>& parts,
                                  std::vector<std::string>& told);

}  // namespace tactics
