// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/evaluate_repair.h"

#include "cli/report/say.h"
#include "cli/verbs/evaluate_picture.h"
#include "cli/verbs/evaluate_run.h"
#include "filters/drawing_of.h"
#include "print/format.h"
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

RepairTrial try_recipe(const EvaluateRequest& request, const Subject& subject, const Candidate& candidate,
                       const MappedPicture& mapped) {
    RepairTrial trial;
    const double start = cpu_ms();
    ReadyRecipe ready = make_ready(request, subject, candidate);
    const Drawing drawing = drawing_of(run(ready.recipe, std::move(ready.image)));
    Mended mended = mend_for(request.sheet, drawing, false);
    advise(request.sheet, mended);
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

}  // namespace

int run_repair_study(const EvaluateRequest& request) {
    RepairStudy study;
    for (const Subject& subject : request.subjects) study.pictures.push_back(subject.name);
    for (const Candidate& candidate : request.candidates)
        study.recipes.push_back({candidate.name, std::vector<RepairTrial>(request.subjects.size())});
    study.problems = try_all(request, false, [&](std::size_t i, const MappedPicture& mapped) {
        return [&, i, mapped](std::size_t c) {
            study.recipes[c].trials[i] = try_recipe(request, request.subjects[i], request.candidates[c], mapped);
        };
    });
    print_out(request.json ? repair_json(study) : repair_text(study));
    const int code = tell_problems(study.problems, "drawn");
    if (request.charts.empty()) return code;
    if (const Plot plot = repair_plot(study); !plot.marks.empty())
        write_charts(plot, request.charts);
    else
        say("there is no chart: no picture here has a contour map");
    return code;
}

}  // namespace tactics
