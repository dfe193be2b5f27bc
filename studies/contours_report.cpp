// SPDX-License-Identifier: Apache-2.0
#include "studies/contours_report.h"

#include <algorithm>
#include <array>
#include <utility>

#include "studies/told_table.h"
#include "tactics/text/json.h"
#include "tactics/text/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

Phrase dial_text(const RecipeResult& result, const Figures& figures) {
    const std::string& setting = result.settings[figures.dial.setting];
    if (!figures.swept) return setting;
    const float level = levels()[figures.dial.level];
    const Phrase dial = level > 0 ? phrase("strength {0}", fixed_numeral(level, 1)) : phrase("all lines");
    return setting.empty() ? dial : phrase("{0}, {1}", setting, dial);
}

struct Column {
    SourceWords heading;
    std::string_view field;  // of the CSV
};
constexpr Column kColumns[] = {
    {SourceWords("recipe"), "recipe"},    {SourceWords("F"), "f"},
    {SourceWords("P"), "precision"},      {SourceWords("R"), "recall"},
    {SourceWords("OIS F"), "ois_f"},      {SourceWords("line mm"), "stroke_length_mm"},
    {SourceWords("strokes"), "strokes"},  {SourceWords("crowded"), "crowded"},
    {SourceWords("CPU ms"), "recipe_ms"}, {SourceWords("with reading"), "whole_ms"},
    {SourceWords("pictures"), "scored"},  {SourceWords("failed"), "failed"},
    {SourceWords("nothing"), "nothing"},  {SourceWords("best at"), "best_at"},
};

std::size_t people_scored(const std::vector<Counts>& people) {
    return static_cast<std::size_t>(std::count_if(people.begin(), people.end(), [](const Counts& c) { return c.truth > 0; }));
}

// What people reach is beside what recipes do.
struct PeopleRow {
    SourceWords name;
    const std::vector<Counts>& counts;  // by picture
};
std::array<PeopleRow, 2> people_rows(const Evaluation& evaluation) {
    return {PeopleRow{SourceWords("people"), evaluation.people}, PeopleRow{SourceWords("simplest person"), evaluation.simplest}};
}

std::vector<ToldRow> rows_of(const Evaluation& evaluation) {
    std::vector<ToldRow> rows;
    for (const RecipeResult& result : evaluation.recipes) {
        const Figures figures = figures_of(result);
        ToldRow row{result.recipe};
        if (figures.scored > 0) {
            row.insert(row.end(), {fixed(figures.best.f(), 3), fixed(figures.best.precision(), 3),
                                   fixed(figures.best.recall(), 3), fixed(figures.best_each.f(), 3)});
            if (figures.has_touch)
                row.insert(row.end(), {fixed(figures.length, 0), fixed(figures.strokes, 1), fixed(figures.crowded, 3)});
        }
        row.resize(8);
        if (figures.scored > 0) row.insert(row.end(), {fixed(figures.recipe_ms, 1), fixed(figures.whole_ms, 1)});
        row.resize(10);
        row.insert(row.end(), {std::to_string(figures.scored), std::to_string(figures.failed), std::to_string(figures.nothing),
                               figures.scored > 0 ? dial_text(result, figures) : Phrase()});
        rows.push_back(std::move(row));
    }
    for (const auto& [name, counts] : people_rows(evaluation)) {
        const Counts sum = sum_of(counts);
        if (sum.truth == 0) continue;
        ToldRow row{phrase(name), fixed(sum.f(), 3), fixed(sum.precision(), 3), fixed(sum.recall(), 3)};
        row.resize(10);
        row.push_back(std::to_string(people_scored(counts)));
        row.resize(std::size(kColumns));
        rows.push_back(std::move(row));
    }
    return rows;
}

void add_counts(JsonObject& json, const Counts& counts) {
    json.add("f", counts.f());
    json.add("precision", counts.precision());
    json.add("recall", counts.recall());
}

std::string picture_json(const std::string& name, const std::vector<Trial>& settings, const Dial& dial) {
    JsonObject json;
    json.add("picture", name);
    for (const Trial& trial : settings) {
        if (trial.scored()) continue;
        json.add("error", trial.error);
        return json.text();
    }
    const Trial& trial = settings[dial.setting];
    add_counts(json, trial.curve[dial.level]);
    const Dial own = best_of(settings);
    json.add("best_f", settings[own.setting].curve[own.level].f());
    json.add_raw("nothing", trial.nothing() ? "true" : "false");
    if (trial.touch) {
        json.add("stroke_length_mm", trial.touch->length);
        json.add("strokes", static_cast<double>(trial.touch->strokes));
        json.add("crowded_mm", trial.touch->crowded);
    }
    json.add("recipe_ms", trial.recipe_ms);
    json.add("whole_ms", trial.whole_ms);
    return json.text();
}

std::string recipe_json(const Evaluation& evaluation, const RecipeResult& result) {
    const Figures figures = figures_of(result);
    JsonObject json;
    json.add("recipe", result.recipe);
    json.add("scored", static_cast<double>(figures.scored));
    json.add("failed", static_cast<double>(figures.failed));
    if (figures.scored > 0) {
        json.add("nothing", static_cast<double>(figures.nothing));
        add_counts(json, figures.best);
        json.add("ois_f", figures.best_each.f());
        json.add("best_at", dial_text(result, figures).english());
        if (figures.has_touch) {
            json.add("stroke_length_mm", figures.length);
            json.add("strokes", figures.strokes);
            json.add("crowded", figures.crowded);
        }
        json.add("recipe_ms", figures.recipe_ms);
        json.add("whole_ms", figures.whole_ms);
    }
    std::vector<std::string> pictures;
    for (std::size_t i = 0; i < result.trials.size(); ++i)
        pictures.push_back(picture_json(evaluation.pictures[i], result.trials[i], figures.dial));
    json.add_raw("pictures", json_array(pictures));
    return json.text();
}

std::string people_json(const Evaluation& evaluation, const PeopleRow& people) {
    JsonObject json;
    json.add("recipe", people.name.text);
    json.add("scored", static_cast<double>(people_scored(people.counts)));
    if (people_scored(people.counts) > 0) add_counts(json, sum_of(people.counts));
    std::vector<std::string> pictures;
    for (std::size_t i = 0; i < evaluation.pictures.size(); ++i) {
        JsonObject picture;
        picture.add("picture", evaluation.pictures[i]);
        picture.add("annotators", static_cast<double>(evaluation.annotators[i]));
        if (people.counts[i].truth > 0) add_counts(picture, people.counts[i]);
        pictures.push_back(picture.text());
    }
    json.add_raw("pictures", json_array(pictures));
    return json.text();
}

}  // namespace

std::string evaluation_table(const Evaluation& evaluation, std::string_view language) {
    std::vector<ToldRow> rows{{}};
    for (const Column& column : kColumns) rows[0].push_back(phrase(column.heading));
    for (ToldRow& row : rows_of(evaluation)) {
        if (!row[7].empty()) row[7] = percent(parse_number(row[7].english()).value_or(0));
        rows.push_back(std::move(row));
    }
    return told_table(rows, language);
}

std::string evaluation_csv(const Evaluation& evaluation) {
    std::vector<ToldRow> rows{{}};
    for (const Column& column : kColumns) rows[0].emplace_back(column.field);
    for (ToldRow& row : rows_of(evaluation)) rows.push_back(std::move(row));
    return told_csv(rows);
}

std::string evaluation_json(const Evaluation& evaluation) {
    std::string text;
    for (const RecipeResult& result : evaluation.recipes) text += recipe_json(evaluation, result) + "\n";
    for (const PeopleRow& people : people_rows(evaluation)) text += people_json(evaluation, people) + "\n";
    JsonObject whole;
    whole.add("pictures", static_cast<double>(evaluation.pictures.size()));
    whole.add_raw("problems", json_text_array(evaluation.problems));
    whole.add("peak_memory_mib", evaluation.peak_memory_mib);
    return text + whole.text() + "\n";
}

std::vector<Phrase> nothing_lines(const Evaluation& evaluation) {
    std::vector<Phrase> lines;
    for (const RecipeResult& result : evaluation.recipes) {
        const Figures figures = figures_of(result);
        std::vector<Phrase> names;
        for (std::size_t i = 0; i < result.trials.size(); ++i)
            if (figures.scored > 0 && result.trials[i][figures.dial.setting].nothing()) names.push_back(evaluation.pictures[i]);
        if (!names.empty())
            lines.push_back(phrases(names.size(), "recipe {1} draws nothing on {0} picture: {2}",
                                    "recipe {1} draws nothing on {0} pictures: {2}", result.recipe, row_of(names)));
    }
    return lines;
}

}  // namespace tactics
