// SPDX-License-Identifier: Apache-2.0
// `evaluate` without --study: scores lines against the contours that people drew.
#include <sys/resource.h>

#include <cmath>

#include "studies/contours_report.h"
#include "studies/frontier.h"
#include "studies/picture.h"
#include "studies/work.h"
#include "tactics/error.h"
#include "tactics/job/workers.h"
#include "tactics/measure/consensus.h"
#include "tactics/measure/lines.h"

namespace tactics {

namespace {

double peak_memory_mib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts in KiB
}

// All about one picture.
struct Rows {
    std::size_t annotators = 0;
    Counts people, simplest;
    std::vector<std::vector<Trial>> trials;  // by candidate and setting
    std::vector<Phrase> problems;
};

class Examination {
public:
    Examination(const StudyRequest& request, const Subject& subject) : request_(request), subject_(subject) {}

    Rows rows() {
        Rows rows;
        read_truths(rows);
        rows.annotators = truths_.size();
        if (rows.problems.empty()) {
            const Failure failure = failure_of(subject_.picture, [&] {
                rows.people = score_people(truths_);
                rows.simplest = score_person(truths_, simplest_of(truths_));
            });
            if (!failure.text.empty()) rows.problems.push_back(failure.text);
        }
        const Phrase unscored = rows.problems.empty() ? Phrase() : rows.problems.front();
        for (const Candidate& candidate : request_.candidates) {
            auto& trials = rows.trials.emplace_back();
            for (std::size_t setting = 0; setting < candidate.settings.size(); ++setting) {
                Trial trial;
                trial.error = unscored.english();
                if (unscored.empty()) {
                    const Failure failure = failure_of(subject_.picture, [&] { run(candidate, setting, trial); });
                    trial.error = failure.text.english();
                    if (!trial.scored()) rows.problems.push_back(of_recipe(label(candidate, setting), failure.text));
                }
                trials.push_back(std::move(trial));
            }
        }
        return rows;
    }

private:
    static std::string label(const Candidate& candidate, std::size_t setting) {
        return candidate.name + (candidate.settings[setting].empty() ? "" : " " + candidate.settings[setting]);
    }

    void read_truths(Rows& rows) {
        const auto add = [&](Phrase problem) {
            if (!problem.empty()) rows.problems.push_back(std::move(problem));
        };
        add(failure_of(subject_.picture, [&] {
                info_ = size_of(request_, subject_);
                read_through(request_, subject_);
            }).text);
        if (!rows.problems.empty()) return;
        if (subject_.truths.empty())
            add(phrase("{0}: {1}", subject_.picture,
                       phrase("it has no contour map; add {0}_gt1.png, or take the picture away", subject_.name)));
        for (const auto& path : subject_.truths)
            add(failure_of(path, [&] { truths_.push_back(read_truth(path, info_.width, info_.height)); }).text);
    }

    void run(const Candidate& candidate, std::size_t setting, Trial& trial) const {
        const double start = cpu_ms();
        ReadyRecipe ready = make_ready(request_, subject_, candidate, setting);
        const double read = cpu_ms();
        const Artwork artwork = tactics::run(ready.recipe, std::move(ready.from));
        const double end = cpu_ms();
        trial.recipe_ms = end - read;
        trial.whole_ms = end - start;
        const Medium& medium = *request_.sheet.medium;
        if (const auto* drawing = std::get_if<Drawing>(&artwork)) trial.touch = touch_load(*drawing, medium.gap + medium.line);
        trial.curve = score_at_levels(lines_of(artwork, info_.width, info_.height), truths_);
    }

    const StudyRequest& request_;
    const Subject& subject_;
    PictureInfo info_;
    std::vector<PixelSet> truths_;
};

Evaluation collect(const StudyRequest& request, std::vector<Rows> all) {
    Evaluation evaluation;
    evaluation.problems = request.problems;
    for (const Candidate& candidate : request.candidates) evaluation.recipes.push_back({candidate.name, candidate.settings, {}});
    for (std::size_t i = 0; i < all.size(); ++i) {
        Rows& rows = all[i];
        evaluation.pictures.push_back(request.subjects[i].name);
        evaluation.annotators.push_back(rows.annotators);
        evaluation.people.push_back(rows.people);
        evaluation.simplest.push_back(rows.simplest);
        evaluation.problems.insert(evaluation.problems.end(), rows.problems.begin(), rows.problems.end());
        for (std::size_t c = 0; c < rows.trials.size(); ++c) evaluation.recipes[c].trials.push_back(std::move(rows.trials[c]));
    }
    evaluation.peak_memory_mib = peak_memory_mib();
    return evaluation;
}

std::vector<Phrase> remarks_on(const Evaluation& evaluation, const Sheet& sheet) {
    std::vector<Phrase> remarks = nothing_lines(evaluation);
    std::size_t maps = 0;
    for (const std::size_t annotators : evaluation.annotators) maps += annotators;
    remarks.push_back(phrase("{0} with {1}, as drawn for {2} on {3}; peak memory {4} MiB",
                             phrases(evaluation.pictures.size(), "{0} picture", "{0} pictures"),
                             phrases(maps, "{0} contour map", "{0} contour maps"), sheet.medium->name, sheet.paper.name,
                             std::to_string(std::lround(evaluation.peak_memory_mib))));
    return remarks;
}

StudyFindings study_contours(const StudyRequest& request, const StudyWatch& watch) {
    std::vector<Rows> all(request.subjects.size());
    work_through(request, watch, all.size(), [&](std::size_t i) {
        all[i] = Examination(request, request.subjects[i]).rows();
        return all[i].problems;
    });
    const Evaluation evaluation = collect(request, std::move(all));
    StudyFindings findings;
    findings.text = evaluation_table(evaluation, request.language);
    findings.csv = evaluation_csv(evaluation);
    findings.json = evaluation_json(evaluation);
    findings.remarks = remarks_on(evaluation, request.sheet);
    findings.problems = evaluation.problems;
    findings.charts.push_back({"", frontier_plot(evaluation)});
    return findings;
}

}  // namespace

extern const Study contours_study;
constinit const Study contours_study{
    .details =
        "--chart draws F against the time of a picture with reading, a mark for each recipe: a disc if no other recipe is both "
        "faster and better, and a ring otherwise; a curve joins the discs. A level line shows the score of the simplest person. "
        "--paper, --medium and --margin also apply to the chart.",
    .charted = recipes_and_person,
    .run = study_contours,
};

}  // namespace tactics
