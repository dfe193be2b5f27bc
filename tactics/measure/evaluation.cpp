// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/evaluation.h"

#include <algorithm>

namespace tactics {

namespace {

bool all_scored(const std::vector<Trial>& settings) {
    return std::all_of(settings.begin(), settings.end(), [](const Trial& trial) { return trial.scored(); });
}

// Calls `visit` with the trials of each picture that was scored at every setting.
template <typename Visit>
void for_scored(const RecipeResult& result, Visit visit) {
    for (const auto& settings : result.trials)
        if (all_scored(settings)) visit(settings);
}

void find_dial(Figures& figures, const RecipeResult& result) {
    for (std::size_t setting = 0; setting < result.settings.size(); ++setting)
        for (std::size_t level = 0; level < levels().size(); ++level) {
            Counts sum;
            for_scored(result, [&](const auto& settings) { sum += settings[setting].curve[level]; });
            if (sum.f() <= figures.best.f() && setting + level > 0) continue;
            figures.best = sum;
            figures.dial = {setting, level};
        }
}

}  // namespace

bool Trial::nothing() const { return !curve.empty() && curve.back().lines == 0; }

Dial best_of(const std::vector<Trial>& settings) {
    Dial best;
    for (std::size_t setting = 0; setting < settings.size(); ++setting)
        for (std::size_t level = 0; level < levels().size(); ++level)
            if (settings[setting].curve[level].f() > settings[best.setting].curve[best.level].f()) best = {setting, level};
    return best;
}

double median_of(std::vector<double> values) {
    if (values.empty()) return 0;
    const std::size_t middle = values.size() / 2;
    std::sort(values.begin(), values.end());
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

Counts sum_of(const std::vector<Counts>& counts) {
    Counts sum;
    for (const Counts& one : counts) sum += one;
    return sum;
}

Figures figures_of(const RecipeResult& result) {
    Figures figures;
    find_dial(figures, result);
    std::vector<double> recipe_ms, whole_ms;
    TouchLoad touch;
    std::size_t drawings = 0;
    for (const auto& settings : result.trials) {
        if (!all_scored(settings)) {
            ++figures.failed;
            continue;
        }
        ++figures.scored;
        const Dial own = best_of(settings);
        figures.best_each += settings[own.setting].curve[own.level];
        const Trial& trial = settings[figures.dial.setting];
        if (trial.nothing()) ++figures.nothing;
        if (trial.curve.front().lines != trial.curve.back().lines) figures.swept = true;
        recipe_ms.push_back(trial.recipe_ms);
        whole_ms.push_back(trial.whole_ms);
        if (!trial.touch) continue;
        ++drawings;
        touch.length += trial.touch->length;
        touch.crowded += trial.touch->crowded;
        touch.strokes += trial.touch->strokes;
    }
    figures.recipe_ms = median_of(std::move(recipe_ms));
    figures.whole_ms = median_of(std::move(whole_ms));
    if (drawings > 0) {
        figures.has_touch = true;
        figures.length = touch.length / static_cast<double>(drawings);
        figures.strokes = static_cast<double>(touch.strokes) / static_cast<double>(drawings);
        figures.crowded = touch.length > 0 ? touch.crowded / touch.length : 0;
    }
    return figures;
}

}  // namespace tactics
