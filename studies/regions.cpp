// SPDX-License-Identifier: Apache-2.0
#include "studies/regions.h"

#include <algorithm>
#include <optional>

#include "studies/picture.h"
#include "studies/told_table.h"
#include "studies/work.h"
#include "tactics/measure/consensus.h"
#include "tactics/measure/lines.h"
#include "tactics/text/json.h"
#include "tactics/text/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

struct RegionRow {
    Phrase name;
    bool has_levels = false;          // else it is a person, whose regions are what they are
    std::vector<RegionTrial> trials;  // by picture; those without a curve could not be scored
};

struct RegionStudy {
    std::vector<std::string> pictures;
    std::vector<RegionRow> rows;  // the recipes, people, and the simplest person
    std::vector<Phrase> problems;
};

// The map of a picture's annotators, each as a row's trial.
struct PeopleRegions {
    std::vector<LabelMap> maps;
    std::size_t simplest = 0;

    RegionTrial simplest_against_others() const {
        if (maps.size() < 2) return {};
        std::vector<LabelMap> others = maps;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(simplest));
        return score_regions(at_all_levels(maps[simplest]), others);
    }
};

// By region_levels(): the best level of that picture for covering.
const RegionScore& best_of(const RegionTrial& trial) {
    return *std::max_element(trial.curve.begin(), trial.curve.end(),
                             [](const RegionScore& a, const RegionScore& b) { return a.covering < b.covering; });
}

std::string regions_picture_json(const std::string& name, const RegionTrial& trial) {
    JsonObject json;
    json.add("picture", name);
    const RegionScore& best = best_of(trial);
    json.add("covering", best.covering);
    json.add("rand", best.rand);
    json.add("information", best.information);
    json.add("covering_best", trial.best);
    return json.text();
}

std::string regions_row_json(const RegionStudy& study, const RegionRow& row) {
    const RegionFigures figures = region_figures(row.trials);
    JsonObject json;
    json.add("recipe", row.name.english());
    json.add("scored", static_cast<double>(figures.pictures));
    if (figures.pictures > 0) {
        json.add("covering_ods", figures.covering_ods);
        json.add("rand_ods", figures.rand_ods);
        json.add("information_ods", figures.information_ods);
    }
    if (figures.pictures > 0 && row.has_levels) {
        json.add("covering_ois", figures.covering_ois);
        json.add("covering_best", figures.covering_best);
        json.add("rand_ois", figures.rand_ois);
        json.add("information_ois", figures.information_ois);
        json.add("best_at", static_cast<double>(figures.level));
    }
    std::vector<std::string> pictures;
    for (std::size_t i = 0; i < row.trials.size(); ++i)
        if (!row.trials[i].curve.empty()) pictures.push_back(regions_picture_json(study.pictures[i], row.trials[i]));
    json.add_raw("pictures", json_array(pictures));
    return json.text();
}

// The step where a recipe has nested regions, before it makes lines from them.
std::optional<std::size_t> last_of_regions(const Recipe& recipe) {
    for (std::size_t i = recipe.steps.size(); i-- > 0;)
        if (recipe.steps[i].filter->gives == static_cast<Kinds>(Kind::regions)) return i;
    return std::nullopt;
}

std::vector<std::shared_ptr<const LabelMap>> regions_of_tree(const RegionTree& tree, int width, int height) {
    std::vector<std::shared_ptr<const LabelMap>> maps;
    std::vector<std::uint32_t> before;
    for (const float level : region_levels()) {
        std::vector<std::uint32_t> regions = regions_at(tree, level);
        const bool same = !maps.empty() && regions == before;
        maps.push_back(
            same ? maps.back()
                 : std::make_shared<const LabelMap>(resized(connected(regions, tree.width, tree.height), width, height)));
        before = std::move(regions);
    }
    return maps;
}

}  // namespace

std::vector<std::shared_ptr<const LabelMap>> regions_of_recipe(Recipe recipe, Artwork from, int width, int height) {
    if (const auto nest = last_of_regions(recipe)) {
        recipe.steps.erase(recipe.steps.begin() + static_cast<std::ptrdiff_t>(*nest) + 1, recipe.steps.end());
        return regions_of_tree(std::get<RegionTree>(run(recipe, std::move(from))), width, height);
    }
    const EdgeMap lines =
        lines_of(run(recipe.steps.empty() ? recipe : without_dots(std::move(recipe)), std::move(from)), width, height);
    std::vector<std::shared_ptr<const LabelMap>> maps;
    std::size_t before = 0;
    for (const float level : region_levels()) {
        // Unthinned: pixels that thinning removes at a corner would change sides.
        PixelSet kept{width, height, {}};
        for (std::size_t i = 0; i < lines.strength.size(); ++i)
            if (lines.strength[i] > 0 && lines.strength[i] >= level) kept.pixels.push_back(static_cast<std::uint32_t>(i));
        const bool same = !maps.empty() && kept.pixels.size() == before;
        before = kept.pixels.size();
        maps.push_back(same ? maps.back() : std::make_shared<const LabelMap>(regions_between(kept)));
    }
    return maps;
}

std::vector<LabelMap> regions_of_people(const std::vector<PixelSet>& truths) {
    std::vector<LabelMap> maps;
    for (const PixelSet& truth : truths) maps.push_back(regions_between(truth));
    return maps;
}

namespace {

std::vector<ToldRow> region_rows(const RegionStudy& study) {
    std::vector<ToldRow> rows{{phrase("recipe"), phrase("covering"), phrase("covering OIS"), phrase("covering best"),
                               phrase("PRI"), phrase("PRI OIS"), phrase("VI"), phrase("VI OIS"), phrase("pictures"),
                               phrase("failed"), phrase("best at")}};
    for (const RegionRow& row : study.rows) {
        const RegionFigures figures = region_figures(row.trials);
        const auto shown = [&](double value, bool levels) {
            return figures.pictures > 0 && (row.has_levels || !levels) ? fixed(value, 3) : "";
        };
        rows.push_back({row.name, shown(figures.covering_ods, false), shown(figures.covering_ois, true),
                        shown(figures.covering_best, true), shown(figures.rand_ods, false), shown(figures.rand_ois, true),
                        shown(figures.information_ods, false), shown(figures.information_ois, true),
                        std::to_string(figures.pictures), std::to_string(row.trials.size() - figures.pictures),
                        !row.has_levels || figures.pictures == 0 ? Phrase()
                        : figures.level > 0                      ? phrase("strength {0}", fixed_numeral(figures.level, 1))
                                                                 : phrase("all lines")});
    }
    return rows;
}

std::string region_json(const RegionStudy& study) {
    std::string text;
    for (const RegionRow& row : study.rows) text += regions_row_json(study, row) + "\n";
    return text + study_json("regions", study.pictures.size(), study.problems);
}

StudyFindings run_regions_study(const StudyRequest& request, const StudyWatch& watch) {
    RegionStudy study;
    const std::size_t pictures = request.subjects.size(), recipes = request.candidates.size();
    for (const Subject& subject : request.subjects) study.pictures.push_back(subject.name);
    for (const Candidate& candidate : request.candidates)
        study.rows.push_back({candidate.name, true, std::vector<RegionTrial>(pictures)});
    study.rows.push_back({phrase("people"), false, std::vector<RegionTrial>(pictures)});
    study.rows.push_back({phrase("simplest person"), false, std::vector<RegionTrial>(pictures)});
    study.problems = try_all(request, watch, true, [&](std::size_t i, const MappedPicture& mapped) {
        const PeopleRegions people{regions_of_people(mapped.truths), simplest_of(mapped.truths)};
        study.rows[recipes].trials[i] = score_people(people.maps);
        study.rows[recipes + 1].trials[i] = people.simplest_against_others();
        return [&, i, people](std::size_t c) {
            ReadyRecipe ready = make_ready(request, request.subjects[i], request.candidates[c]);
            const LabelMap& first = people.maps.front();
            study.rows[c].trials[i] = score_regions(
                regions_of_recipe(std::move(ready.recipe), std::move(ready.from), first.width, first.height), people.maps);
        };
    });
    const std::vector<ToldRow> rows = region_rows(study);
    StudyFindings findings;
    findings.text = told_table(rows, request.language);
    findings.csv = told_csv(rows);
    findings.json = region_json(study);
    findings.problems = study.problems;
    return findings;
}

}  // namespace

extern const Study regions_study;
constinit const Study regions_study{
    .name = "regions",
    .details =
        "scores the regions enclosed by a recipe's lines, as the Berkeley benchmark does: covering is how well the recipe's "
        "best regions cover people's regions (intersection over union), PRI the Probabilistic Rand Index, VI the Variation of "
        "Information in bits (less is better). Unmarked columns use the strength that is best for all pictures together (ODS), "
        "OIS the best strength for each picture, and best the best strength for each region. Pixels under a line belong to the "
        "nearest region.",
    .refuses = kAsItIs,
    .without = kDots,
    .run = run_regions_study,
};

}  // namespace tactics
