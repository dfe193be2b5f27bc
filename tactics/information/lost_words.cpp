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
Phrase told(double mm) {
    const double unit = std::pow(10.0, std::floor(std::log10(std::max(mm, 1e-3))) - 1);
    return phrase("{0} mm", numeral(std::round(mm / unit) * unit));
}

std::vector<Phrase> of_lines(const Drawing& lines, const MediumChannel& channel, double scale) {
    std::vector<Phrase> words;
    if (channel.least_apart > 0) {
        const TouchLoad load = touch_load(lines, channel.least_apart / scale);
        if (load.length > 0 && load.crowded / load.length > kSmallShare)
            words.push_back(phrase("lines closer than {0} ({1} of their length)", told(channel.least_apart),
                                   percent(load.crowded / load.length)));
    }
    const auto is_short = [&](const Stroke& stroke) { return length_of(stroke) * scale < channel.shortest; };
    const auto count = std::count_if(lines.strokes.begin(), lines.strokes.end(), is_short);
    if (count > 0)
        words.push_back(phrase("lines shorter than {0} ({1} of {2})", told(channel.shortest), std::to_string(count),
                               std::to_string(lines.strokes.size())));
    return words;
}

}  // namespace

std::vector<Phrase> lost_words(MeasuredScene& scene, const MediumChannel& channel, const Fit& fit) {
    const LevelGrid& grid = scene.pyramid.whole();
    std::vector<Phrase> words;
    if (scene.lines) words = of_lines(*scene.lines, channel, fit.scale);
    if (fit.levels < grid.levels) {
        const double between = (scene.high - scene.low) / fit.levels;
        words.push_back(phrase("heights between its {0} levels ({1} apart)", std::to_string(fit.levels), told(between)));
    }
    if (fit.longest < std::max(grid.columns, grid.rows)) {
        const double there = fit.scale * std::max(scene.width, scene.height) / fit.longest;
        words.push_back(phrase("what is smaller than {0} there", told(there)));
    }
    if (channel.travel > 0 && scene.high - scene.low > channel.travel)
        words.push_back(phrase("heights over {0}", told(channel.travel)));
    return words;
}

}  // namespace tactics
