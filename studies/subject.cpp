// SPDX-License-Identifier: Apache-2.0
#include "studies/subject.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include "filters/arc_worth.h"
#include "filters/subject.h"
#include "studies/picture.h"
#include "studies/regions.h"
#include "studies/work.h"
#include "tactics/measure/consensus.h"
#include "tactics/measure/objects.h"
#include "tactics/text/json.h"
#include "tactics/text/table.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kFound = 0.5;  // as in the PASCAL challenges (M. Everingham et al. 2010)

SubjectFinder find_in(std::shared_ptr<const LabelMap> map) {
    return [map = std::move(map)](const SubjectHint& hint) {
        return hint.box ? regions_in(*map, *hint.box) : region_at(*map, hint.point.value());
    };
}

SubjectTrial try_finder(const SubjectFinder& finder, const std::vector<AgreedObject>& objects) {
    SubjectTrial trial;
    trial.tried = true;
    for (const AgreedObject& object : objects) {
        trial.box.push_back(overlap_of(finder({object.box, std::nullopt}), object.mask));
        trial.point.push_back(overlap_of(finder({std::nullopt, object.inside}), object.mask));
    }
    return trial;
}

// Against the objects of the others.
SubjectTrial try_person_subject(std::vector<LabelMap> maps, std::size_t simplest) {
    const auto own = std::make_shared<const LabelMap>(std::move(maps[simplest]));
    maps.erase(maps.begin() + static_cast<std::ptrdiff_t>(simplest));
    return try_finder(find_in(own), agreed_objects(maps));
}

SubjectTrial try_box(const std::vector<AgreedObject>& objects, const LabelMap& map) {
    SubjectTrial trial;
    trial.tried = true;
    for (const AgreedObject& object : objects) {
        const auto [left, top, right, bottom] = object.box;
        std::vector<std::uint8_t> mask(map.label.size(), 0);
        for (int y = top; y < bottom; ++y)
            std::fill_n(mask.begin() + static_cast<std::ptrdiff_t>(y) * map.width + left, right - left, std::uint8_t{1});
        trial.box.push_back(overlap_of(mask, object.mask));
    }
    return trial;
}

struct Overlaps {
    std::vector<double> box, point;
    std::size_t failed = 0;
};

Overlaps overlaps_in(const SubjectRow& row) {
    Overlaps overlaps;
    for (const SubjectTrial& trial : row.trials) {
        overlaps.box.insert(overlaps.box.end(), trial.box.begin(), trial.box.end());
        overlaps.point.insert(overlaps.point.end(), trial.point.begin(), trial.point.end());
        overlaps.failed += trial.tried ? 0 : 1;
    }
    return overlaps;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double found_of(const std::vector<double>& values) {
    const auto found = std::count_if(values.begin(), values.end(), [](double value) { return value >= kFound; });
    return static_cast<double>(found) / static_cast<double>(values.size());
}

std::string list_json(const std::vector<double>& values) {
    std::vector<std::string> texts;
    for (const double value : values) texts.push_back(fixed(value, 4));
    return json_array(texts);
}

std::string subject_row_json(const SubjectStudy& study, const SubjectRow& row) {
    const Overlaps overlaps = overlaps_in(row);
    JsonObject json;
    json.add("recipe", row.name.english());
    json.add("failed", static_cast<double>(overlaps.failed));
    json.add("objects", static_cast<double>(overlaps.box.size()));
    if (!overlaps.box.empty()) {
        json.add("box_iou", mean_of(overlaps.box));
        json.add("box_found", found_of(overlaps.box));
    }
    if (!overlaps.point.empty()) {
        json.add("point_iou", mean_of(overlaps.point));
        json.add("point_found", found_of(overlaps.point));
    }
    std::vector<std::string> pictures;
    for (std::size_t i = 0; i < row.trials.size(); ++i) {
        if (row.trials[i].box.empty()) continue;
        JsonObject picture;
        picture.add("picture", study.pictures[i]);
        picture.add_raw("box_iou", list_json(row.trials[i].box));
        picture.add_raw("point_iou", list_json(row.trials[i].point));
        pictures.push_back(picture.text());
    }
    json.add_raw("pictures", json_array(pictures));
    return json.text();
}

}  // namespace

SubjectFinder find_among_regions(Recipe recipe, Image image, int width, int height) {
    return find_in(regions_of_recipe(std::move(recipe), std::move(image), width, height).back());
}

SubjectFinder find_subjects(Recipe recipe, Image image, int width, int height) {
    const auto lines = std::find_if(recipe.steps.begin(), recipe.steps.end(),
                                    [](const Step& step) { return step.filter->takes == static_cast<Kinds>(Kind::regions); });
    if (lines == recipe.steps.end()) return find_among_regions(std::move(recipe), std::move(image), width, height);
    recipe.steps.erase(lines, recipe.steps.end());
    const auto tree = std::make_shared<const RegionTree>(std::get<RegionTree>(run(recipe, std::move(image))));
    const auto chances = std::make_shared<const std::vector<float>>(arc_chances_of(*tree).drawn);
    return [=](const SubjectHint& hint) {
        // Of a point the middle of its pixel.
        const auto at = hint.box ? *hint.box : std::array<int, 4>{(*hint.point)[0], (*hint.point)[1], 0, 0};
        const double half = hint.box ? 0 : 0.5;
        Spot spot{(at[0] + half) / width, (at[1] + half) / height, 0, 0};
        spot.right = hint.box ? static_cast<double>(at[2]) / width : spot.left;
        spot.bottom = hint.box ? static_cast<double>(at[3]) / height : spot.top;
        const std::vector<bool> faces = faces_of_subject(*tree, *chances, spot);
        std::vector<std::uint8_t> mask;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int u = std::min(static_cast<int>((x + 0.5) * tree->width / width), tree->width - 1);
                const int v = std::min(static_cast<int>((y + 0.5) * tree->height / height), tree->height - 1);
                mask.push_back(faces[tree->face[static_cast<std::size_t>(v) * static_cast<std::size_t>(tree->width) +
                                                static_cast<std::size_t>(u)]]
                                   ? 1
                                   : 0);
            }
        return mask;
    };
}

std::vector<ToldRow> subject_rows(const SubjectStudy& study) {
    std::vector<ToldRow> rows{{phrase("recipe"), phrase("box IoU"), phrase("box found"), phrase("point IoU"),
                               phrase("point found"), phrase("objects"), phrase("failed")}};
    for (const SubjectRow& row : study.rows) {
        const Overlaps overlaps = overlaps_in(row);
        const auto mean = [](const std::vector<double>& values) { return values.empty() ? "" : fixed(mean_of(values), 3); };
        const auto found = [](const std::vector<double>& values) { return values.empty() ? "" : fixed(found_of(values), 3); };
        rows.push_back({row.name, mean(overlaps.box), found(overlaps.box), mean(overlaps.point), found(overlaps.point),
                        std::to_string(overlaps.box.size()), std::to_string(overlaps.failed)});
    }
    return rows;
}

std::string subject_json(const SubjectStudy& study) {
    std::string text;
    for (const SubjectRow& row : study.rows) text += subject_row_json(study, row) + "\n";
    JsonObject whole;
    whole.add("study", "subject");
    whole.add("pictures", static_cast<double>(study.pictures.size()));
    whole.add("without_object", static_cast<double>(study.bare));
    whole.add_raw("problems", json_text_array(study.problems));
    return text + whole.text() + "\n";
}

StudyFindings study_subject(const StudyRequest& request, const StudyWatch& watch, const SubjectSearch& search) {
    SubjectStudy study;
    const std::size_t pictures = request.subjects.size(), recipes = request.candidates.size();
    for (const Subject& subject : request.subjects) study.pictures.push_back(subject.name);
    for (const Candidate& candidate : request.candidates)
        study.rows.push_back({candidate.name, std::vector<SubjectTrial>(pictures)});
    study.rows.push_back({phrase("simplest person"), std::vector<SubjectTrial>(pictures)});
    study.rows.push_back({phrase("the box alone"), std::vector<SubjectTrial>(pictures)});
    std::vector<std::uint8_t> bare(pictures, 0);
    study.problems = try_all(request, watch, true, [&](std::size_t i, const MappedPicture& mapped) {
        const std::vector<LabelMap> people = regions_of_people(mapped.truths);
        std::vector<AgreedObject> objects = agreed_objects(people);
        bare[i] = objects.empty() ? 1 : 0;
        study.rows[recipes].trials[i] = try_person_subject(people, simplest_of(mapped.truths));
        study.rows[recipes + 1].trials[i] = try_box(objects, people.front());
        return [&, i, objects = std::move(objects), info = mapped.info](std::size_t c) {
            SubjectTrial& trial = study.rows[c].trials[i];
            trial.tried = objects.empty();
            if (trial.tried) return;
            ReadyRecipe ready = make_ready(request, request.subjects[i], request.candidates[c]);
            if (!std::holds_alternative<Image>(ready.from))
                throw Error(Fault::failed, "", phrase("it is no picture, in which things could be looked for; take it away"));
            trial = try_finder(search(std::move(ready.recipe), std::get<Image>(std::move(ready.from)), info.width, info.height),
                               objects);
        };
    });
    study.bare = static_cast<std::size_t>(std::count(bare.begin(), bare.end(), std::uint8_t{1}));
    const std::vector<ToldRow> rows = subject_rows(study);
    StudyFindings findings;
    findings.text = told_table(rows, request.language);
    findings.csv = told_csv(rows);
    findings.json = subject_json(study);
    if (study.bare > 0)
        findings.remarks.push_back(phrases(study.bare, "{0} of {1} pictures has no object that {2} people agree on",
                                           "{0} of {1} pictures have no object that {2} people agree on",
                                           std::to_string(pictures), std::to_string(kAgree)));
    findings.problems = study.problems;
    findings.undone = SourceWords("{0} could not be tried:");
    return findings;
}

namespace {

StudyFindings run_subject_study(const StudyRequest& request, const StudyWatch& watch) {
    return study_subject(request, watch, find_subjects);
}

}  // namespace

extern const Study subject_study;
constinit const Study subject_study{
    .name = "subject",
    .details =
        "points at the things that at least 3 people agree on (regions that overlap by 0.7, cover 2 to 50 percent of the "
        "picture and do not touch all four sides), with a box around each and with a point deep inside, and measures how well "
        "the thing found covers each: IoU is intersection over union, found the share with 0.5 or more. A recipe with the "
        "filters nest and outlines finds things as convert --subject does; others choose among the regions that their lines "
        "enclose. The row the box alone takes everything in the box.",
    .refuses = kAsItIs,
    .without = kDots,
    .run = run_subject_study,
};

}  // namespace tactics
