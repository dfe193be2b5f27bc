// SPDX-License-Identifier: Apache-2.0
// The parts of a plot that can be felt separately. They are in a list (list.inc), one per line.
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
#include "tactics/text/phrase.h"

namespace tactics {

/// The plot to be felt, and its firmness.
struct PlotFeel {
    const Plot& plot;  ///< needed only while parts are built
    PlotFrame frame;
    ForceLaw law;               ///< for all firm parts; no part is stiffer
    FixtureSettings fixture;    ///< for the curves; softened until it rises no steeper than the law
    double resolution = 0.055;  ///< mm that the device resolves
};

struct PlotPart {
    std::string_view name = {};  ///< "curves", as it is typed
    std::string_view what = {};
    /// nullptr: the plot has no such part. `told` receives one line for each thing left out.
    std::unique_ptr<Scene> (*make)(const PlotFeel& feel, std::vector<Phrase>& told) = nullptr;
};

std::span<const PlotPart* const> plot_parts();

/// All parts with those names, in a box that activates them: open towards walls and axes; elsewhere it extends beyond the field
/// as far as any part can be felt.
std::unique_ptr<Scene> plot_scene(const PlotFeel& feel, const std::vector<const PlotPart*>& parts, std::vector<Phrase>& told);

}  // namespace tactics
