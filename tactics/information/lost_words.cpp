// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/lost_words.h"

#include <algorithm>
#include <cmath>

#include "tactics/information/channel.h"
#include "tactics/measure/touch.h"
#include "tactics/text/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kSmallShare = 0.005;  // of the length: less is not told

// Two digits are enough to go by.
std::string told(double mm) {
    const double unit = std::pow(10.0, std::floor(std::log10(std::max(mm, 1e-3))) - 1);
    return to_text(std::round(mm / unit) * unit) + " mm";
}

std::vector<std::string> of_lines(const Drawing& lines, const MediumChannel& channel, double scale) {
    std::vector<std::string> words;
    if (channel.least_apart > 0) {
        const TouchLoad load = touch_load(lines, channel.least_apart / scale);
        if (load.length > 0 && load.crowded / load.length > kSmallShare)
            words.push_back("lines closer than " + told(channel.least_apart) + " (" + percent(load.crowded / load.length) +
                            " of their length)");
    }
    const auto is_short = [&](const Stroke& stroke) { return length_of(stroke) * scale < channel.shortest; };
    const auto count = std::count_if(lines.strokes.begin(), lines.strokes.end(), is_short);
    if (count > 0)
        words.push_back("lines shorter than " + told(channel.shortest) + " (" + std::to_string(count) + " of " +
                        std::to_string(lines.strokes.size()) + ")");
    return words;
}

}  // namespace

std::vector<std::string> lost_words(MeasuredScene& scene, const MediumChannel& channel, const Fit& fit) {
    const LevelGrid& grid = scene.pyramid.whole();
    std::vector<std::string> words;
    if (scene.lines) words = of_lines(*scene.lines, channel, fit.scale);
    if (fit.levels < grid.levels) {
        const double between = (scene.high - scene.low) / fit.levels;
        words.push_back("heights between its " + std::to_string(fit.levels) + " levels (" + told(between) + " apart)");
    }
    if (fit.longest < std::max(grid.columns, grid.rows)) {
        const double there = fit.scale * std::max(scene.width, scene.height) / fit.longest;
        words.push_back("what is smaller than " + told(there) + " there");
    }
    if (channel.travel > 0 && scene.high - scene.low > channel.travel) words.push_back("heights over " + told(channel.travel));
    return words;
}

}  // namespace tactics
