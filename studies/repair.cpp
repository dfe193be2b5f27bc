// SPDX-License-Identifier: Apache-2.0
#include "studies/repair.h"

#include "filters/drawing_of.h"
#include "print/format.h"
#include "studies/frontier.h"
#include "studies/picture.h"
#include "studies/work.h"
#include "tactics/job/make_pages.h"
#include "tactics/job/mending.h"
#include "tactics/layout/lay_out.h"
#include "tactics/measure/lines.h"

namespace tactics {

namespace {

Counts counts_of(const Drawing& drawing, const MappedPicture& mapped) {
    if (mapped.truths.empty()) return {};
    return score_at_levels(lines_of(drawing, mapped.info.width, mapped.info.height), mapped.truths).back();  // all that is drawn
}

RepairTrial try_recipe_repair(const StudyRequest& request, const Subject& subject, const Candidate& candidate,
                              const MappedPicture& mapped) {
    RepairTrial trial;
    const double start = cpu_ms();
    ReadyRecipe ready = make_ready(request, subject, candidate);
    const Drawing drawing = drawing_of(run(ready.recipe, std::move(ready.from)));
    Mended mended = mend_for(*request.sheet.medium, ready.place.width, drawing, false);
    advise(request.sheet, mended, true);
    const Format& pdf = *find_format("pdf");
    pdf.encode_pages(pages_of(mended.drawing, request.sheet).all, Settings(pdf.options));
    trial.page_ms = cpu_ms() - start;
    const double made = cpu_ms();
    repair(scaled_to(drawing, ready.place.width), *request.sheet.medium);
    trial.repair_ms = cpu_ms() - made;
    trial.before = counts_of(drawing, mapped);
    trial.after = counts_of(mended.drawing, mapped);
    trial.hard_before = mended.told.broken_before;
    trial.hard_after = mended.told.broken_after;
    trial.kept = mended.told.kept;
    trial.legible = mended.told.advice.empty();
    trial.tried = true;
    return trial;
}

StudyFindings run_repair_study(const StudyRequest& request, const StudyWatch& watch) {
    RepairStudy study;
    for (const Subject& subject : request.subjects) study.pictures.push_back(subject.name);
    for (const Candidate& candidate : request.candidates)
        study.recipes.push_back({candidate.name, std::vector<RepairTrial>(request.subjects.size())});
    study.problems = try_all(request, watch, false, [&](std::size_t i, const MappedPicture& mapped) {
        return [&, i, mapped](std::size_t c) {
            study.recipes[c].trials[i] = try_recipe_repair(request, request.subjects[i], request.candidates[c], mapped);
        };
    });
    StudyFindings findings;
    findings.text = repair_text(study, request.language);
    findings.json = repair_json(study);
    findings.problems = study.problems;
    findings.undone = SourceWords("{0} could not be drawn:");
    findings.charts.push_back({"", repair_plot(study)});
    if (findings.charts.front().plot.marks.empty())
        findings.charts.front().missing = phrase("there is no chart: no picture here has a contour map");
    return findings;
}

constexpr SourceWords kTextOrJson = "the study repair gives text or --json";
constexpr Refusal kRepairRefuses[] = {{"sweep", kTextOrJson}, {"csv", kTextOrJson}};

}  // namespace

extern const Study repair_study;
constinit const Study repair_study{
    .name = "repair",
    .details =
        "makes the page of each picture, mends it as convert does, and counts the pages that broke a hard rule, the places "
        "where they broke one before and after, and the pages that are not fit to be felt at this size (convert then advises "
        "the user to split, enlarge or describe the picture). It also gives R and F of the whole drawing before and after, the "
        "share of line that stays, and CPU seconds: the median for a page from picture to PDF, the median for its repair, and "
        "the longest repair. --chart draws places against R.",
    .needs_maps = false,
    .refuses = kRepairRefuses,
    .without = kDotsAndRegions,
    .charted = recipes_alone,
    .run = run_repair_study,
};

}  // namespace tactics
