// SPDX-License-Identifier: Apache-2.0
#include "studies/picture.h"

#include <algorithm>

#include "filters/list.h"
#include "studies/work.h"
#include "tactics/error.h"
#include "tactics/job/drawable.h"
#include "tactics/job/holds.h"
#include "tactics/job/reading.h"
#include "tactics/job/workers.h"
#include "tactics/layout/place.h"
#include "tactics/text/json.h"

namespace tactics {

namespace {

bool is_picture(Source& source) { return look_at(source) == Holds::picture; }

ReadyRecipe ready_drawing(const StudyRequest& request, Source source, const Candidate& candidate, std::size_t setting) {
    Job job;
    job.input = source.name;
    job.words = WordsWish::leave;
    if (!candidate.recipes.empty())
        job.recipe = candidate.recipes[setting];
    else
        job.chain = candidate.chain;
    Notes notes;
    const Drawable drawable = drawable_of(source, job, request.sheet, notes);
    ReadyRecipe ready;
    ready.place = place_on(request.sheet, drawable.aspect(request.sheet)).drawing;
    DrawingWay way;
    ready.from = drawable.draw(request.sheet, ready.place, drawable.part, drawable.words, way);
    return ready;
}

}  // namespace

Source open_picture(const StudyRequest& request, const Subject& subject) {
    Source source = open_source(subject.picture);
    source.allowed = request.allowed;
    return source;
}

PictureInfo size_of(const StudyRequest& request, const Subject& subject) {
    Source source = open_picture(request, subject);
    if (is_picture(source)) return inspect_picture(source);
    constexpr int kSide = 1000;
    if (subject.truths.empty()) return {"drawing", kSide, kSide};
    Source truth = open_source(subject.truths.front());
    const PictureInfo info = inspect_picture(truth);
    return {"drawing", info.width, info.height};
}

void read_through(const StudyRequest& request, const Subject& subject) {
    Source source = open_picture(request, subject);
    if (is_picture(source)) read_picture(source, {1, false});
}

MappedPicture read_mapped(const StudyRequest& request, const Subject& subject, bool needs_map) {
    MappedPicture mapped;
    mapped.info = size_of(request, subject);
    if (needs_map && subject.truths.empty())
        throw Error(Fault::failed, "", phrase("it has no contour map; add {0}_gt1.png, or take the picture away", subject.name));
    for (const auto& path : subject.truths) mapped.truths.push_back(read_truth(path, mapped.info.width, mapped.info.height));
    return mapped;
}

ReadyRecipe make_ready(const StudyRequest& request, const Subject& subject, const Candidate& candidate, std::size_t setting) {
    Source source = open_picture(request, subject);
    if (!is_picture(source)) return ready_drawing(request, std::move(source), candidate, setting);
    const PictureInfo info = inspect_picture(source);
    Reading reading(source);
    ReadyRecipe ready;
    ready.recipe = fit_to(*request.sheet.medium, candidate.recipes.empty()
                                                     ? assemble(candidate.chain, find_recipe(choose(reading).recipe, "auto"))
                                                     : candidate.recipes[setting]);
    if (!draws_whole(ready.recipe))
        throw Error(Fault::failed, "", phrase("only a part of the picture is left, which no contour map fits; leave out crop"));
    ready.place = place_on(request.sheet, aspect_of(info)).drawing;
    ready.from = read_for(ready.recipe, ready.place, reading);
    return ready;
}

Recipe without_dots(Recipe recipe) {
    std::erase_if(recipe.steps, [](const Step& step) { return step.filter->name == "halftone"; });
    const bool draws =
        std::any_of(recipe.steps.begin(), recipe.steps.end(), [](const Step& step) { return step.filter->name != "resample"; });
    if (!draws) throw Error(Fault::failed, "", phrase("it draws neither lines nor regions that could be compared; leave it out"));
    return recipe;
}

Phrase of_recipe(const std::string& recipe, const Phrase& problem) { return phrase("recipe {0}: {1}", recipe, problem); }

std::vector<Phrase> try_all(const StudyRequest& request, const StudyWatch& watch, bool needs_maps, const OpenPicture& open) {
    std::vector<std::vector<Phrase>> problems(request.subjects.size());
    work_through(request, watch, request.subjects.size(), [&](std::size_t i) {
        const Subject& subject = request.subjects[i];
        TryRecipe attempt;
        if (const Failure failure =
                failure_of(subject.picture, [&] { attempt = open(i, read_mapped(request, subject, needs_maps)); });
            !failure.text.empty())
            problems[i].push_back(failure.text);
        for (std::size_t c = 0; attempt && c < request.candidates.size(); ++c)
            if (const Failure failure = failure_of(subject.picture, [&] { attempt(c); }); !failure.text.empty())
                problems[i].push_back(of_recipe(request.candidates[c].name, failure.text));
        return problems[i];
    });
    std::vector<Phrase> all = request.problems;
    for (const auto& own : problems) all.insert(all.end(), own.begin(), own.end());
    return all;
}

std::string study_json(std::string_view study, std::size_t pictures, const std::vector<Phrase>& problems) {
    JsonObject whole;
    whole.add("study", study);
    whole.add("pictures", static_cast<double>(pictures));
    whole.add_raw("problems", json_text_array(problems));
    return whole.text() + "\n";
}

}  // namespace tactics
