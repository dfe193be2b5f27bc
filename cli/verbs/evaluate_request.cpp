// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/evaluate_request.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cli/chain.h"
#include "cli/report/user_language.h"
#include "cli/request.h"
#include "filters/list.h"
#include "print/format.h"
#include "studies/list.h"
#include "tactics/error.h"
#include "tactics/layout/place.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const std::string& folder) {
    std::vector<std::string> files;
    std::error_code fault;
    for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
        const std::string name = at->path().filename().string();
        std::error_code unknown;
        if (name[0] != '.' && !at->is_directory(unknown)) files.push_back((fs::path(folder) / name).string());
    }
    if (fault) throw Error(Fault::failed, folder, phrase("this folder cannot be read: {0}", fault.message()));
    return files;
}

// Every second picture: so a recipe can be tuned on one half and measured on the other.
void keep_half(std::vector<Subject>& subjects, const std::string& half) {
    if (half == "all") return;
    if (half != "even" && half != "odd")
        throw Error(Fault::usage, "--half",
                    phrase("it cannot be \"{0}\"{1}; it is even, odd or all", half.substr(0, 80),
                           did_you_mean(half, {"even", "odd", "all"})));
    std::vector<Subject> kept;
    for (std::size_t i = half == "odd" ? 0 : 1; i < subjects.size(); i += 2) kept.push_back(std::move(subjects[i]));
    subjects = std::move(kept);
}

void plan_subjects(EvaluateRequest& request, const Given& given, const Disk& disk) {
    if (given.words.size() != 1)
        throw Error(
            Fault::usage, "evaluate",
            phrase("name one folder with pictures in images/ and contour maps in gt/; for example: tactics evaluate photos/"));
    const std::string& folder = given.words[0];
    const std::string inner = (fs::path(folder) / "images").string();
    const std::string pictures = disk.is_folder(inner) ? inner : folder;
    const std::string truth = given.value("--truth", (fs::path(folder) / "gt").string());
    const bool there = disk.is_folder(truth);
    if (!there && (request.study->needs_maps || given.has("--truth")))
        throw Error(Fault::failed, truth, phrase("there is no such folder; name the folder of the contour maps with --truth"));
    // Studies that need no maps report more if there are some.
    Pairing pairing = pair_up(files_in(pictures), there ? files_in(truth) : std::vector<std::string>{});
    request.subjects = std::move(pairing.subjects);
    request.problems = std::move(pairing.problems);
    if (request.subjects.empty()) throw Error(Fault::failed, pictures, phrase("there is no picture in this folder"));
    keep_half(request.subjects, given.value("--half", "all"));
    if (request.subjects.empty())
        throw Error(Fault::usage, "--half", phrase("there is only one picture, which is the first (odd); leave --half out"));
}

// --sweep kmeans.k=2,3,4
std::vector<Change> sweep_of(const Given& given) {
    std::vector<Change> values;
    const std::string text = given.value("--sweep");
    if (!given.has("--sweep")) return values;
    const auto equals = text.find('=');
    if (equals == std::string::npos)
        throw Error(Fault::usage, "--sweep",
                    phrase("\"{0}\" is no sweep; write FILTER.OPTION=V1,V2,V3, for example kmeans.k=2,3,4", text.substr(0, 80)));
    for (std::size_t from = equals + 1; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        values.push_back(parse_change(text.substr(0, equals + 1) + text.substr(from, comma - from), "--sweep"));
        from = comma + 1;
    }
    if (find_filter(filters(), values.front().name) == nullptr)
        throw Error(Fault::usage, "--sweep",
                    phrase("{0} is a format, and no page is made here; sweep the option of a filter", values.front().name));
    return values;
}

void refuse_formats(const Given& given) {
    for (std::size_t i = 0; i < given.all("--set").size(); ++i) {
        const Change change = parse_change(given.all("--set")[i], "--set " + std::to_string(i + 1));
        if (find_filter(filters(), change.name) == nullptr)
            throw Error(Fault::usage, change.place,
                        phrase("{0} is a format, and --set does not reach formats here; leave it out, or use --dpi for a chart",
                               change.name));
    }
}

bool has_filter(const Recipe& recipe, std::string_view name) {
    return std::any_of(recipe.steps.begin(), recipe.steps.end(), [&](const Step& step) { return step.filter->name == name; });
}

std::string label_of_steps(const std::vector<Step>& steps) {
    std::string label;
    for (const Step& step : steps) {
        const std::string settings = step.settings.to_text();
        label += (label.empty() ? "" : ", ") + std::string(step.filter->name) + (settings.empty() ? "" : " " + settings);
    }
    return label;
}

Candidate make_candidate(const std::string& name, RecipeWish chain, const std::vector<Change>& sweep) {
    Candidate candidate;
    candidate.name = name;
    if (name.empty()) candidate.name = label_of_steps(chain.base->steps);
    if (!name.empty() && !chain.added.empty()) candidate.name += ", " + label_of_steps(chain.added);
    if (chain.base) {
        for (const Change& change : sweep) {
            RecipeWish changed = chain;
            changed.changes.push_back(change);
            Recipe base = *chain.base;
            base.steps.insert(base.steps.end(), chain.added.begin(), chain.added.end());
            if (!has_filter(base, change.name)) continue;
            candidate.recipes.push_back(assemble(changed, *chain.base));
            candidate.settings.push_back(change.name + "." + change.option + "=" + change.value);
        }
        if (candidate.recipes.empty()) candidate.recipes.push_back(assemble(chain, *chain.base));
    }
    if (candidate.settings.empty()) candidate.settings.push_back("");
    candidate.chain = std::move(chain);
    return candidate;
}

std::vector<std::string> usual_recipes(const Study& study) {
    std::vector<std::string> names(study.recipes.begin(), study.recipes.end());
    if (!names.empty()) return names;
    for (const NamedRecipe& recipe : named_recipes())
        if (std::find(study.without.begin(), study.without.end(), recipe.name) == study.without.end())
            names.emplace_back(recipe.name);
    names.emplace_back("auto");
    return names;
}

void plan_candidates(EvaluateRequest& request, const Given& given, const Disk& disk) {
    if (given.value("--detail") == "best")
        throw Error(Fault::usage, "--detail",
                    phrase("best depends on a medium, and the same is asked of all pictures here; take a number"));
    const std::vector<Change> sweep = sweep_of(given);
    refuse_formats(given);
    std::vector<std::string> names = given.all("--recipe");
    const bool everything = names.empty() && !given.has("--filter");
    if (everything) names = usual_recipes(*request.study);
    if (names.empty()) names.emplace_back("");  // the recipe is made of --filter
    for (const std::string& name : names) {
        Given one = given;
        if (!name.empty()) one.add("--recipe", name);  // the last one counts
        RecipeWish chain = read_chain(one, disk);
        // By default, all recipes that have the dial are used; a named recipe must have it.
        if (everything && chain.base && !has_filter(*chain.base, "strongest")) chain.detail.clear();
        request.candidates.push_back(make_candidate(name, std::move(chain), sweep));
    }
    if (everything && !request.study->besides.empty()) {
        Given one = given;
        one.add("--filter", std::string(request.study->besides));
        RecipeWish chain = read_chain(one, disk);
        chain.detail.clear();
        request.candidates.push_back(make_candidate("", std::move(chain), sweep));
    }
    const bool swept = std::any_of(request.candidates.begin(), request.candidates.end(),
                                   [](const Candidate& candidate) { return !candidate.settings.front().empty(); });
    if (!sweep.empty() && !swept)
        throw Error(Fault::usage, "--sweep",
                    phrase("no recipe here has the filter {0}, so this would do nothing; name one that has", sweep.front().name));
}

// What one study alone asks for.
void plan_options(EvaluateRequest& request, const Given& given) {
    if (request.study != nullptr) request.settings = Settings(request.study->options);
    for (const Study* study : studies())
        for (const Option& option : study->options) {
            const std::string flag = "--" + std::string(option.name);
            if (!given.has(flag)) continue;
            const auto number = parse_number(given.value(flag));
            if (!number || *number < option.min || *number > option.max || *number != std::floor(*number))
                throw Error(Fault::usage, flag,
                            phrase("it must be a whole number from {0} to {1}", numeral(option.min), numeral(option.max)));
            if (study != request.study)
                throw Error(Fault::usage, flag, phrase("{0}; it is for --study {1}", phrase(study->no_options), study->name));
            request.settings.set(option.name, given.value(flag), flag, study->name);
        }
}

void plan_study(EvaluateRequest& request, const Given& given) {
    const std::string name = given.value("--study");
    request.study = given.has("--study") && name.empty() ? nullptr : find_study(name);
    plan_options(request, given);
    const auto refuse = [&](std::string_view option, const Phrase& why) {
        const std::string flag = "--" + std::string(option);
        if (given.has(flag)) throw Error(Fault::usage, flag, phrase("{0}; leave it out", why));
    };
    const bool charted = request.study != nullptr && request.study->charted != nullptr;
    if (!charted) refuse("chart", phrase("this study has no chart"));
    if (const auto names = study_names(); request.study == nullptr)
        throw Error(Fault::usage, "--study",
                    phrase("there is no study \"{0}\"{1}; there are {2}", name.substr(0, 80), did_you_mean(name, names),
                           listed({names.begin(), names.end()})));
    for (const auto& [option, why] : request.study->refuses) refuse(option, phrase(why));
}

void plan_sheet(EvaluateRequest& request, const Given& given) {
    // The page of `convert -o page.pdf`.
    const Format& usual = *find_format("pdf");
    const bool own = !request.study->paper.empty();
    request.sheet.paper = find_paper(given.value("--paper", own ? request.study->paper : usual.paper), "--paper");
    request.sheet.medium = &find_medium(given.value("--medium", usual.medium), "--medium");
    if (given.has("--margin")) request.sheet.margin = length_value(given, "--margin", 0);
    if (own) request.sheet.margin = 0;
    place_on(request.sheet, 1);
}

// Outputs written last are checked first, so that no work is lost.
void check_csv(const EvaluateRequest& request, const Disk& disk) {
    if (request.csv.empty() || request.csv == "-") return;
    if (disk.is_folder(request.csv)) throw Error(Fault::usage, "--csv", phrase("{0} is a folder; name a file", request.csv));
    const std::string folder = fs::path(request.csv).parent_path().string();
    if (!folder.empty() && !disk.is_folder(folder))
        throw Error(Fault::usage, "--csv", phrase("there is no folder {0}; make it, or name another file", folder));
    for (const ChartFile& chart : request.chart_files)
        if (disk.identity(chart.path) == disk.identity(request.csv))
            throw Error(Fault::usage, "--csv", phrase("{0} is the file of --chart, too; name another", request.csv));
}

}  // namespace

EvaluateRequest plan_evaluation(const Given& given, const Disk& disk) {
    EvaluateRequest request;
    plan_study(request, given);
    plan_candidates(request, given, disk);
    request.chart_files = plan_charts(given, disk);
    for (const ChartFile& chart : request.chart_files) request.charts.push_back(chart.path);
    if (request.study->charted != nullptr) check_charts(request.study->charted(request.candidates), request.chart_files);
    plan_sheet(request, given);
    plan_subjects(request, given, disk);
    request.csv = given.value("--csv");
    if (given.has("--csv") && request.csv.empty()) throw Error(Fault::usage, "--csv", phrase("the name of the file is missing"));
    check_csv(request, disk);
    request.allowed = allowed_formats(given);
    request.workers = workers_value(given);
    request.quiet = given.has("--quiet");
    request.json = given.has("--json");
    request.language = user_language();
    if (request.json && request.csv == "-")
        throw Error(Fault::usage, "standard output",
                    phrase("only one can be written to it: --json or --csv; write the other to a file"));
    return request;
}

}  // namespace tactics
