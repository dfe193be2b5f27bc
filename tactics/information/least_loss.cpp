// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/least_loss.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tactics/information/code_length.h"
#include "tactics/information/entropy.h"
#include "tactics/text/table.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr double kEvenness[] = {0, 0.25, 0.5, 0.75, 1};
constexpr int kSmoothings[] = {0, 1};
constexpr double kShares[] = {1, 0.84, 0.71};  // of the most cells: a quarter and half an octave less

// The mean over a square of cells, of those that there are.
LevelGrid smoothed(const LevelGrid& grid, int reach) {
    if (reach == 0) return grid;
    std::vector<std::uint16_t> out;
    out.reserve(grid.count());
    const auto value = [&](int x, int y) { return grid.values[static_cast<std::size_t>(y * grid.columns + x)]; };
    for (int y = 0; y < grid.rows; ++y)
        for (int x = 0; x < grid.columns; ++x) {
            std::uint64_t sum = 0, cells = 0;
            for (int j = std::max(0, y - reach); j <= std::min(grid.rows - 1, y + reach); ++j)
                for (int i = std::max(0, x - reach); i <= std::min(grid.columns - 1, x + reach); ++i, ++cells) sum += value(i, j);
            out.push_back(static_cast<std::uint16_t>((sum + cells / 2) / cells));
        }
    return {grid.columns, grid.rows, 1, grid.levels, std::move(out)};
}

// Between heights as they are and their rank; never out of order.
LevelGrid evened(const LevelGrid& grid, double evenness, int levels) {
    const std::vector<std::uint64_t> counts = counts_of(grid);
    std::vector<std::uint16_t> becomes(counts.size());
    double below = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto here = static_cast<double>(counts[i]);
        const double rank = (below + here / 2) / static_cast<double>(grid.count()),
                     height = (static_cast<double>(i) + 0.5) / static_cast<double>(counts.size());
        below += here;
        const double at = evenness * rank + (1 - evenness) * height;
        becomes[i] = static_cast<std::uint16_t>(std::clamp(std::floor(at * levels), 0.0, levels - 1.0));
    }
    std::vector<std::uint16_t> out(grid.count());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = becomes[grid.values[i]];
    return {grid.columns, grid.rows, 1, levels, std::move(out)};
}

}  // namespace

LevelGrid transformed(MeasuredScene& scene, const Transformation& transformation, int levels) {
    const LevelGrid& there = scene.pyramid.at(transformation.longest);
    if (transformation.evenness == 0 && transformation.smoothing == 0) return with_levels(there, levels);
    return evened(smoothed(there, transformation.smoothing), transformation.evenness, std::min(levels, there.levels));
}

HeightMap transformed_heights(MeasuredScene& scene, const Transformation& transformation, int levels) {
    const LevelGrid grid = transformed(scene, transformation, levels);
    HeightMap map{grid.columns, grid.rows, scene.width / grid.columns, {}};
    map.heights.reserve(grid.count());
    const double step = (scene.high - scene.low) / grid.levels;
    for (std::size_t i = 0; i < grid.count(); ++i)
        map.heights.push_back(static_cast<float>(scene.low + (grid.values[i] + 0.5) * step));
    return map;
}

LeastLoss least_loss(MeasuredScene& scene, const MediumChannel& channel) {
    const Carried plain = carried_by(scene, channel);
    const double all = scene.measures.bits;
    LeastLoss least{{plain.fit.longest, 0, 0}, plain.loss, plain.loss, plain.fit.levels, 0};
    if (plain.loss == 0) return least;
    for (const double share : kShares)
        for (const int smoothing : kSmoothings)
            for (const double evenness : kEvenness) {
                const Transformation tried{std::max(1, static_cast<int>(share * plain.fit.longest)), smoothing, evenness};
                if (scene.is_drawn() && (smoothing > 0 || evenness > 0)) continue;
                ++least.tried;
                const double code = code_length(transformed(scene, tried, plain.fit.levels)).best.bits;
                const double loss = std::max(0.0, all - std::min(plain.capacity, code)) / all;
                if (loss >= least.loss) continue;
                least.loss = loss;
                least.best = tried;
            }
    return least;
}

Phrase explained(const LeastLoss& least, const LevelGrid& whole) {
    if (least.plain == 0) return phrase("nothing is lost as it is");
    std::vector<Phrase> steps;
    const Transformation& made = least.best;
    if (made.longest < std::max(whole.columns, whole.rows))
        steps.push_back(phrase("{0} cells long", std::to_string(made.longest)));
    if (made.smoothing > 0) steps.push_back(phrase("smoothed over {0} cells", std::to_string(2 * made.smoothing + 1)));
    if (made.evenness > 0) steps.push_back(phrase("heights evened by {0}", percent(made.evenness)));
    const std::string tried = std::to_string(least.tried);
    if (least.loss < least.plain)
        return phrase("least loss {0} instead of {1}, {2} ({3} tried)", exact_percent(least.loss), exact_percent(least.plain),
                      row_of(steps), tried);
    return phrase("nothing loses less than its own filter, {0} ({1} tried)", exact_percent(least.plain), tried);
}

}  // namespace tactics
