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

constexpr std::size_t kFinalists = 3;  // of which the whole is coded, too, where strips were

// What was tried, and the loss by the whole or by strips.
struct Tried {
    Transformation made;
    double loss = 0;
    bool by_strips = false;
};

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

// Levels of what was resampled and smoothed already.
LevelGrid in_levels(const LevelGrid& smooth, const Transformation& made, int levels) {
    if (made.evenness == 0 && made.smoothing == 0) return with_levels(smooth, levels);
    return evened(smooth, made.evenness, std::min(levels, smooth.levels));
}

// Of a large grid strips over all of its height, which are enough to compare transformations by.
LevelGrid strips_of(const LevelGrid& grid) {
    constexpr int kEnough = 400'000, kStrip = 64;  // cells, rows
    const int strips = std::max(2, kEnough / (kStrip * grid.columns));
    if (grid.slices != 1 || grid.count() <= kEnough || grid.rows <= 2 * strips * kStrip) return grid;
    std::vector<std::uint16_t> cells;
    for (int strip = 0; strip < strips; ++strip) {
        const auto first = static_cast<std::size_t>(strip * (grid.rows - kStrip) / (strips - 1));
        const std::size_t columns = static_cast<std::size_t>(grid.columns), last = (first + kStrip) * columns;
        for (std::size_t i = first * columns; i < last; ++i) cells.push_back(grid.values[i]);
    }
    return {grid.columns, strips * kStrip, 1, grid.levels, std::move(cells)};
}

}  // namespace

LevelGrid transformed(MeasuredScene& scene, const Transformation& transformation, int levels) {
    const LevelGrid& there = scene.pyramid.at(transformation.longest);
    return in_levels(smoothed(there, transformation.smoothing), transformation, levels);
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
    const auto lost = [&](double code) { return (all - std::min(plain.capacity, code)) / all; };  // under 0: more than enough
    std::vector<Tried> tried;
    const double floor = std::max(0.0, lost(plain.capacity));
    bool ends = plain.loss <= floor;  // what strips say ends nothing
    for (const double share : kShares) {
        const int longest = std::max(1, static_cast<int>(share * plain.fit.longest));
        const LevelGrid& there = scene.pyramid.at(longest);
        const LevelGrid strips = strips_of(there);
        const double times = static_cast<double>(there.count()) / static_cast<double>(strips.count());
        for (const int smoothing : kSmoothings) {
            if (scene.is_drawn() && smoothing > 0) continue;
            const LevelGrid smooth = smoothed(strips, smoothing);
            for (const double evenness : kEvenness) {
                if (ends || (scene.is_drawn() && evenness > 0)) continue;
                const Transformation made{longest, smoothing, evenness};
                const double loss = lost(times * code_length(in_levels(smooth, made, plain.fit.levels)).best.bits);
                tried.push_back({made, loss, times > 1});
                ends = times == 1 && loss <= floor;
            }
        }
    }
    least.tried = tried.size();
    std::stable_sort(tried.begin(), tried.end(), [](const Tried& a, const Tried& b) { return a.loss < b.loss; });
    if (tried.size() > kFinalists) tried.resize(kFinalists);
    for (const Tried& one : tried) {
        const double loss =
            std::max(0.0, one.by_strips ? lost(code_length(transformed(scene, one.made, plain.fit.levels)).best.bits) : one.loss);
        if (loss >= least.loss) continue;
        least.loss = loss;
        least.best = one.made;
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
