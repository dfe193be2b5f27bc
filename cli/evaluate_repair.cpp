#include "cli/evaluate_repair.h"

#include "cli/conversion.h"
#include "cli/evaluate_run.h"
#include "cli/mending.h"
#include "cli/reading.h"
#include "cli/say.h"
#include "cli/workers.h"
#include "filters/list.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/measure/lines.h"

namespace tactics {

namespace {

Counts counts_of(const Drawing& drawing, int width, int height, const std::vector<PixelSet>& truths) {
    if (truths.empty()) return {};
    return score_at_levels(lines_of(drawing, width, height), truths).back();  // all that is drawn
}

RepairTrial try_recipe(const EvaluateRequest& request, const Subject& subject, const Candidate& candidate,
                       const std::vector<PixelSet>& truths) {
    RepairTrial trial;
    const double start = cpu_ms();
    Source source = open_source(subject.picture);
    const PictureInfo info = inspect_picture(source);
    Reading reading(source);
    const Recipe recipe = fit_to(
        *request.sheet.medium, candidate.recipes.empty() ? assemble(candidate.chain, find_recipe(choose(reading).recipe, "auto"))
                                                         : candidate.recipes[0]);
    if (!draws_whole(recipe))
        throw Error(Fault::failed, "", "only a part of the picture is left, which cannot be compared; leave out crop");
    const Rect place = place_on(request.sheet, aspect_of(info)).drawing;
    const Drawing drawing = drawing_of(run(recipe, read_for(recipe, place, reading)));
    Mended mended = mend_for(request.sheet, drawing, false);
    advise(request.sheet, mended);
    const Format& pdf = *find_format("pdf");
    pdf.encode_pages(pages_of(mended.drawing, request.sheet).all, Settings(pdf.options));
    trial.page_ms = cpu_ms() - start;
    const double made = cpu_ms();
    repair(scaled_to(drawing, place.width), *request.sheet.medium);
    trial.repair_ms = cpu_ms() - made;
    trial.before = counts_of(drawing, info.width, info.height, truths);
    trial.after = counts_of(mended.drawing, info.width, info.height, truths);
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
    study.problems = request.problems;
    for (const Subject& subject : request.subjects) study.pictures.push_back(subject.name);
    for (const Candidate& candidate : request.candidates)
        study.recipes.push_back({candidate.name, std::vector<RepairTrial>(request.subjects.size())});
    std::vector<std::vector<std::string>> problems(request.subjects.size());
    work_through(request, request.subjects.size(), [&](std::size_t i) {
        const Subject& subject = request.subjects[i];
        std::vector<PixelSet> truths;
        const auto note = [&](const std::string& who, const Failure& failure) {
            if (!failure.text.empty()) problems[i].push_back(who + failure.text);
        };
        note("", failure_of(subject.picture, [&] {
                 Source source = open_source(subject.picture);
                 const PictureInfo info = inspect_picture(source);
                 for (const auto& path : subject.truths) truths.push_back(read_truth(path, info.width, info.height));
             }));
        for (std::size_t c = 0; c < request.candidates.size() && problems[i].empty(); ++c)
            note("recipe " + request.candidates[c].name + ": ", failure_of(subject.picture, [&] {
                     study.recipes[c].trials[i] = try_recipe(request, subject, request.candidates[c], truths);
                 }));
        return problems[i];
    });
    for (const auto& own : problems) study.problems.insert(study.problems.end(), own.begin(), own.end());
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
