// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/channel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tactics/information/lost_words.h"

namespace tactics {

namespace {

constexpr double kMostCells = 1e9;

// mm there for a mm of the scene: as large as it holds it, whichever way up; of what has no end as large as it is.
double scale_of(const MeasuredScene& scene, const MediumChannel& channel) {
    if (channel.width <= 0) return 1;
    const auto [short_side, long_side] = std::minmax(channel.width, channel.height);
    return std::min(long_side / std::max(scene.width, scene.height), short_side / std::min(scene.width, scene.height));
}

// To the nearest: nobody feels half a cell at an edge.
int cells_on(double mm, double pitch) { return static_cast<int>(std::clamp(std::round(mm / pitch), 1.0, kMostCells)); }

}  // namespace

Fit fit_of(const MeasuredScene& scene, const MediumChannel& channel) {
    const LevelGrid& grid = scene.pyramid.whole();
    Fit fit{scale_of(scene, channel), 1, channel.levels};
    const double longer = fit.scale * std::max(scene.width, scene.height);
    fit.longest = std::min(cells_on(longer, channel.pitch), std::max(grid.columns, grid.rows));
    if (channel.step > 0 && scene.high > scene.low)
        fit.levels = 1 + static_cast<int>(std::min(std::min(scene.high - scene.low, channel.travel) / channel.step, kMostCells));
    fit.levels = std::clamp(fit.levels, 2, grid.levels);
    return fit;
}

Carried carried_by(MeasuredScene& scene, const MediumChannel& channel) {
    const double all = scene.measures.bits;
    if (!(all > 0)) throw std::logic_error("of a scene of no bits nothing can be lost");
    Carried carried{.fit = fit_of(scene, channel)};
    const auto [longest, levels] = std::pair(carried.fit.longest, carried.fit.levels);
    const LevelGrid& there = scene.pyramid.at(longest);
    carried.columns = there.columns;
    carried.rows = there.rows;
    const double longer = cells_on(carried.fit.scale * std::max(scene.width, scene.height), channel.pitch),
                 shorter = cells_on(carried.fit.scale * std::min(scene.width, scene.height), channel.pitch);
    carried.capacity = raw_bits(longer * shorter, channel.step > 0 ? channel.travel / channel.step + 1 : channel.levels);
    carried.bits = std::min({carried.capacity, all, scene.pyramid.most_bits(longest, levels)});
    carried.ratio = carried.bits / all;
    carried.loss = std::max(all - carried.bits, 0.0) / all;
    if (scene.is_drawn() || carried.loss > 0) carried.lost = lost_words(scene, channel, carried.fit);
    return carried;
}

}  // namespace tactics
