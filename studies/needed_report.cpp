// SPDX-License-Identifier: Apache-2.0
// The study of what is needed as text and in JSON.
#include <cmath>
#include <map>

#include "studies/needed.h"
#include "studies/picture.h"
#include "studies/told_table.h"
#include "tactics/text/json.h"
#include "tactics/text/rounded.h"
#include "tactics/text/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

Phrase value_text(double value) { return std::isfinite(value) ? numeral(value) : phrase("all"); }

std::string chosen_text(const NeededRecipe& recipe) {
    std::map<std::string, std::size_t> counts;
    for (const auto& name : recipe.chosen) ++counts[name];
    std::string text;
    for (const auto& [name, count] : counts) text += (text.empty() ? "" : ", ") + name + " " + std::to_string(count);
    return text;
}

std::string numbers_json(const std::vector<double>& numbers) {
    std::vector<std::string> texts;
    for (const double number : numbers) texts.push_back(std::isfinite(number) ? fixed(number, 4) : json_text("all"));
    return json_array(texts);
}

void add_quartiles(JsonObject& json, const std::string& name, const Quartiles& quartiles) {
    json.add(name + "_lower_quartile", quartiles.low);
    json.add(name + "_median", quartiles.middle);
    json.add(name + "_upper_quartile", quartiles.high);
}

std::string dial_json(const NeededDial& dial, const NeededRecipe& recipe, std::size_t index) {
    const auto& curves = recipe.curves[index];
    const NeededSummary summary = summary_of(curves, dial.values);
    JsonObject json;
    json.add("dial", dial.name);
    json.add_raw("values", numbers_json(dial.values));
    json.add("scored", static_cast<double>(summary.pictures));
    json.add("nothing", static_cast<double>(summary.nothing));
    json.add("more_than_needed", static_cast<double>(summary.more));
    if (summary.pictures > 0) {
        json.add_raw("mean_f", numbers_json(summary.mean_f));
        json.add("best_f", summary.best_f);
        json.add("own_f", summary.own_f);
        add_quartiles(json, "own", summary.own);
    }
    if (summary.pictures > summary.nothing) add_quartiles(json, "needed", summary.needed);
    std::vector<std::string> pictures;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        JsonObject picture;
        picture.add("picture", recipe.pictures[index][i]);
        picture.add_raw("f", numbers_json(curves[i].f));
        if (const auto needed = needed_of(curves[i], dial.values)) picture.add("needed", *needed);
        picture.add("own", curves[i].own);
        picture.add("own_f", curves[i].own_f);
        pictures.push_back(picture.text());
    }
    json.add_raw("pictures", json_array(pictures));
    return json.text();
}

}  // namespace

std::string needed_text(const NeededStudy& study, std::string_view language) {
    std::vector<ToldRow> rows{{phrase("recipe"), phrase("dial"), phrase("a quarter needs"), phrase("half need"),
                               phrase("three quarters"), phrase("it has"), phrase("has more"), phrase("F as it is"),
                               phrase("best F"), phrase("pictures"), phrase("nothing"), phrase("mean F at")}};
    for (const NeededRecipe& recipe : study.recipes)
        for (std::size_t dial = 0; dial < study.dials.size(); ++dial) {
            const auto& values = study.dials[dial].values;
            const NeededSummary summary = summary_of(recipe.curves[dial], values);
            if (summary.pictures == 0) continue;
            const bool some = summary.pictures > summary.nothing;
            std::vector<Phrase> curve;
            for (std::size_t i = 0; i < values.size(); ++i)
                curve.push_back(phrase("{0}: {1}", value_text(values[i]), fixed_numeral(summary.mean_f[i], 3)));
            rows.push_back(
                {recipe.name, study.dials[dial].told, some ? rounded(summary.needed.low, 0.1) : "",
                 some ? rounded(summary.needed.middle, 0.1) : "", some ? rounded(summary.needed.high, 0.1) : "",
                 rounded(summary.own.middle, 0.1),
                 some ? percent(static_cast<double>(summary.more) / static_cast<double>(summary.pictures - summary.nothing)) : "",
                 fixed(summary.own_f, 3), fixed(summary.best_f, 3), std::to_string(summary.pictures),
                 std::to_string(summary.nothing), row_of(curve)});
        }
    std::string text = told_table(rows, language);
    for (const NeededRecipe& recipe : study.recipes)
        if (!recipe.chosen.empty()) text += phrase("{0} chose: {1}.", recipe.name, chosen_text(recipe)).in(language) + "\n";
    return text;
}

std::string needed_json(const NeededStudy& study) {
    std::string text;
    for (const NeededRecipe& recipe : study.recipes) {
        JsonObject json;
        json.add("recipe", recipe.name);
        if (!recipe.chosen.empty()) json.add("chosen", chosen_text(recipe));
        std::vector<std::string> dials;
        for (std::size_t dial = 0; dial < study.dials.size(); ++dial) dials.push_back(dial_json(study.dials[dial], recipe, dial));
        json.add_raw("dials", json_array(dials));
        text += json.text() + "\n";
    }
    return text + study_json("needed", study.tried, study.problems);
}

}  // namespace tactics
