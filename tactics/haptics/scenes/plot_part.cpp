// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/plot_part.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tactics {

#define PART(name) extern const PlotPart name##_part;
#include "tactics/haptics/scenes/list.inc"
#undef PART

std::span<const PlotPart* const> plot_parts() {
    static const PlotPart* const kParts[] = {
#define PART(name) &name##_part,
#include "tactics/haptics/scenes/list.inc"
#undef PART
    };
    return kParts;
}

std::unique_ptr<Scene> plot_scene(const PlotFeel& feel, const std::vector<const PlotPart*>& parts, std::vector<Phrase>& told) {
    constexpr double kOpen = std::numeric_limits<double>::infinity();
    std::vector<std::unique_ptr<Scene>> made;
    for (const PlotPart* part : parts)
        if (auto one = part->make(feel, told)) made.push_back(std::move(one));
    const double reach = std::max(feel.fixture.radius, 10.0);
    return std::make_unique<PartsScene>(
        std::move(made), Box3{{-kOpen, -reach, -kOpen}, {feel.frame.width + reach, kOpen, feel.frame.depth + reach}});
}

}  // namespace tactics
