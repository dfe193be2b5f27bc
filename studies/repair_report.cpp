// SPDX-License-Identifier: Apache-2.0
// The study of repair as text, in JSON and as a chart.
#include <algorithm>

#include "studies/picture.h"
#include "studies/repair.h"
#include "studies/told_table.h"
#include "tactics/text/json.h"
#include "tactics/text/table.h"

namespace tactics {

namespace {

struct Sums {
    std::size_t pictures = 0, hard_before = 0, hard_after = 0, broken_pages = 0, not_legible = 0;
    Counts before, after;
    double kept = 0;                         // mean
    std::vector<double> repair_ms, page_ms;  // in order
};

Sums sums_of(const RepairRecipe& recipe) {
    Sums sums;
    for (const RepairTrial& trial : recipe.trials) {
        if (!trial.tried) continue;
        ++sums.pictures;
        sums.hard_before += trial.hard_before;
        sums.hard_after += trial.hard_after;
        sums.broken_pages += trial.hard_before > 0 ? 1 : 0;
        sums.not_legible += trial.legible ? 0 : 1;
        sums.before += trial.before;
        sums.after += trial.after;
        sums.kept += trial.kept;
        sums.repair_ms.push_back(trial.repair_ms);
        sums.page_ms.push_back(trial.page_ms);
    }
    if (sums.pictures > 0) sums.kept /= static_cast<double>(sums.pictures);
    std::sort(sums.repair_ms.begin(), sums.repair_ms.end());
    std::sort(sums.page_ms.begin(), sums.page_ms.end());
    return sums;
}

double middle_of(const std::vector<double>& sorted) { return sorted.empty() ? 0 : sorted[sorted.size() / 2]; }

}  // namespace

std::string repair_text(const RepairStudy& study, std::string_view language) {
    std::vector<ToldRow> rows{{phrase("recipe"), phrase("pages"), phrase("broken"), phrase("places before"),
                               phrase("places after"), phrase("not legible"), phrase("R before"), phrase("R after"),
                               phrase("F before"), phrase("F after"), phrase("line kept"), phrase("page s"), phrase("repair s"),
                               phrase("longest repair s")}};
    for (const RepairRecipe& recipe : study.recipes) {
        const Sums sums = sums_of(recipe);
        if (sums.pictures == 0) continue;
        const bool scored = sums.before.truth > 0;
        const auto score = [scored](double value) { return scored ? fixed(value, 3) : ""; };
        rows.push_back({recipe.name, std::to_string(sums.pictures), std::to_string(sums.broken_pages),
                        std::to_string(sums.hard_before), std::to_string(sums.hard_after), std::to_string(sums.not_legible),
                        score(sums.before.recall()), score(sums.after.recall()), score(sums.before.f()), score(sums.after.f()),
                        percent(sums.kept), fixed(middle_of(sums.page_ms) / 1000, 3), fixed(middle_of(sums.repair_ms) / 1000, 3),
                        fixed(sums.repair_ms.back() / 1000, 3)});
    }
    return told_table(rows, language);
}

std::string repair_json(const RepairStudy& study) {
    std::string text;
    for (const RepairRecipe& recipe : study.recipes) {
        std::vector<std::string> pictures;
        for (std::size_t i = 0; i < recipe.trials.size(); ++i) {
            const RepairTrial& trial = recipe.trials[i];
            if (!trial.tried) continue;
            JsonObject json;
            json.add("picture", study.pictures[i]);
            json.add("hard_before", static_cast<double>(trial.hard_before));
            json.add("hard_after", static_cast<double>(trial.hard_after));
            json.add_raw("legible", trial.legible ? "true" : "false");
            json.add("kept", trial.kept);
            if (trial.before.truth > 0) {
                json.add("recall_before", trial.before.recall());
                json.add("recall_after", trial.after.recall());
                json.add("f_before", trial.before.f());
                json.add("f_after", trial.after.f());
            }
            json.add("repair_ms", trial.repair_ms);
            json.add("page_ms", trial.page_ms);
            pictures.push_back(json.text());
        }
        JsonObject json;
        json.add("recipe", recipe.name);
        json.add_raw("pictures", json_array(pictures));
        text += json.text() + "\n";
    }
    return text + study_json("repair", study.pictures.size(), study.problems);
}

Plot repair_plot(const RepairStudy& study) {
    Plot plot{"Places too close for a finger, before and after repair",
              {"contours of people that are drawn, percent", false},
              {"places on a page, plus 1", true},
              {},
              {}};
    for (const RepairRecipe& recipe : study.recipes) {
        const Sums sums = sums_of(recipe);
        if (sums.pictures == 0 || sums.before.truth == 0) continue;
        const auto point = [&](const Counts& counts, std::size_t places) {
            return PlotPoint{100 * counts.recall(), 1 + static_cast<double>(places) / static_cast<double>(sums.pictures)};
        };
        const PlotPoint before = point(sums.before, sums.hard_before), after = point(sums.after, sums.hard_after);
        plot.curves.push_back({"", {before, after}});
        plot.marks.push_back({recipe.name, after.x, after.y});
    }
    return plot;
}

}  // namespace tactics
