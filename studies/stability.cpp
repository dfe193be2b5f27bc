// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate --study stability`: how much of a drawing stays when its picture changes.

#include "tactics/measure/stability.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "filters/choose.h"
#include "filters/list.h"
#include "studies/picture.h"
#include "studies/told_table.h"
#include "studies/work.h"
#include "tactics/error.h"
#include "tactics/job/reading.h"
#include "tactics/job/workers.h"
#include "tactics/layout/place.h"
#include "tactics/measure/consensus.h"
#include "tactics/measure/disturbance.h"
#include "tactics/measure/lines.h"
#include "tactics/measure/score.h"
#include "tactics/text/json.h"
#include "tactics/text/table.h"

namespace tactics {

namespace {

// A pixel of a shift, a grey level of noise say something only at a known size. This is A4 at 45 dpi, as photo works.
constexpr int kLongest = 500;

// A page that loses so much of P3 is worse for its reader.
constexpr double kWorse = 0.05;

constexpr int kOtherStarts = 4;
constexpr SourceWords kStart = "start";

// Of one recipe under one change of one picture.
struct Held {
    double mean = 0;
    double least = 0;                 // of the starts; else the same
    std::optional<double> gain = {};  // of P3, where people drew the picture; of starts the worst
};

// By recipe: what held of a picture, or the figures of a known picture.
struct Result {
    std::vector<std::vector<Held>> held;  // by recipe and column; a column less where nothing is left to chance
    std::vector<double> known;            // by recipe
    std::vector<Phrase> problems;         // "recipe sobel: photos/a.jpg: ..."
};

struct StabilityStudy {
    const StudyRequest& request;
    std::vector<KnownPicture> known = known_pictures();
    std::vector<std::string> columns;
    std::vector<Phrase> told;  // the same
    std::vector<Result> pictures, knowns;
    std::vector<Phrase> problems;

    explicit StabilityStudy(const StudyRequest& asked) : request(asked), pictures(asked.subjects.size()), knowns(known.size()) {
        for (const Disturbance& disturbance : disturbances()) told.push_back(phrase(disturbance.name));
        told.push_back(phrase(kStart));
        columns = in_language(told, "en");
        problems = asked.problems;
    }
};

bool has_starts(const Recipe& recipe) {
    return std::any_of(recipe.steps.begin(), recipe.steps.end(), [](const Step& step) { return step.filter->name == "kmeans"; });
}

Recipe started_at(Recipe recipe, int seed) {
    for (Step& step : recipe.steps)
        if (step.filter->name == "kmeans") step.settings.set("seed", std::to_string(seed), step.place, "kmeans");
    return recipe;
}

// A recipe's drawing of a picture, as pixels of a map of that size.
class Draughtsman {
public:
    Draughtsman(const StudyRequest& request, const Candidate& candidate) : request_(request), candidate_(candidate) {}

    Recipe recipe_for(const Image& image) const {
        Recipe recipe = without_dots(
            fit_to(*request_.sheet.medium, candidate_.recipes.empty()
                                               ? assemble(candidate_.chain, find_recipe(choose_recipe(image).recipe, "auto"))
                                               : candidate_.recipes[0]));
        if (!draws_whole(recipe))
            throw Error(Fault::failed, "",
                        phrase("only a part of the picture is left, which cannot be compared; leave out crop"));
        return recipe;
    }

    // How large a pixel of a picture is that fills the page.
    double pixel_of(const Image& image) const {
        return place_on(request_.sheet, static_cast<double>(image.width) / image.height).drawing.width / image.width;
    }

    // `pixel` is the size of a pixel of the map, in mm.
    PixelSet draw(const Recipe& recipe, Image image, double pixel, int width, int height) const {
        if (!uses_colour(recipe)) image = to_grey(std::move(image));
        image.mm_per_pixel = pixel * width / image.width;
        return cut_at(lines_of(tactics::run(recipe, std::move(image)), width, height), 0);
    }

private:
    const StudyRequest& request_;
    const Candidate& candidate_;
};

std::vector<Held> hold(const Draughtsman& draughtsman, const Image& image, std::span<const Disturbed> changes,
                       const std::optional<Consensus>& people) {
    const int width = image.width, height = image.height;
    const double reach = reach_of(width, height);
    const Recipe recipe = draughtsman.recipe_for(image);
    const double pixel = draughtsman.pixel_of(image);
    const PixelSet before = draughtsman.draw(recipe, image, pixel, width, height);
    const auto gain = [&](const PixelSet& from, const PixelSet& to) {
        return people ? std::optional(people->shares_of(to).p3 - people->shares_of(from).p3) : std::nullopt;
    };
    std::vector<Held> held;
    for (const Disturbed& change : changes) {
        const PixelSet after =
            brought_back(draughtsman.draw(draughtsman.recipe_for(change.image), change.image, pixel, change.width, change.height),
                         change, width, height);
        const PixelSet seen_before = seen_by_both(before, change, reach), seen_after = seen_by_both(after, change, reach);
        const double f = agreement(seen_before, seen_after);
        held.push_back({f, f, gain(seen_before, seen_after)});
    }
    if (!has_starts(recipe)) return held;
    Held starts{0, 1};
    for (int seed = 2; seed < 2 + kOtherStarts; ++seed) {
        const PixelSet after = draughtsman.draw(started_at(recipe, seed), image, pixel, width, height);
        const double f = agreement(before, after);
        starts.mean += f / kOtherStarts;
        starts.least = std::min(starts.least, f);
        if (const auto gained = gain(before, after)) starts.gain = std::min(starts.gain.value_or(*gained), *gained);
    }
    held.push_back(starts);
    return held;
}

Result look_at(const StudyRequest& request, const Subject& subject) {
    Result result;
    result.held.resize(request.candidates.size());
    Image image;
    std::vector<Disturbed> changes;
    std::optional<Consensus> people;
    const Failure failure = failure_of(subject.picture, [&] {
        Source source = open_picture(request, subject);
        image = read_picture(source, {kLongest, true});
        for (const Disturbance& disturbance : disturbances()) changes.push_back(disturbance.apply(image));
        const MappedPicture mapped = read_mapped(request, subject, false);
        if (!mapped.truths.empty() && mapped.info.width == image.width) people.emplace(mapped.truths);
    });
    if (!failure.text.empty()) result.problems.push_back(failure.text);
    for (std::size_t c = 0; c < request.candidates.size() && failure.text.empty(); ++c) {
        const Candidate& candidate = request.candidates[c];
        const Failure wrong = failure_of(subject.picture, [&] {
            result.held[c] = hold({request, candidate}, image, changes, people);
        });
        if (!wrong.text.empty()) result.problems.push_back(of_recipe(candidate.name, wrong.text));
    }
    return result;
}

Result look_at(const StudyRequest& request, const KnownPicture& known) {
    Result result;
    for (const Candidate& candidate : request.candidates) {
        const int width = known.contour.width, height = known.contour.height;
        double figure = 0;
        const Failure wrong = failure_of(std::string(known.name.text), [&] {
            const Draughtsman draughtsman(request, candidate);
            const PixelSet lines = draughtsman.draw(draughtsman.recipe_for(known.image), known.image,
                                                    draughtsman.pixel_of(known.image), width, height);
            figure = known.contour.pixels.empty() ? ink_of(lines) : agreement(known.contour, lines);
        });
        if (!wrong.text.empty()) result.problems.push_back(of_recipe(candidate.name, wrong.text));
        result.known.push_back(figure);
    }
    return result;
}

// Of a recipe over the pictures, in one column.
struct Summary {
    std::size_t pictures = 0;
    double mean = 0;
    double least = 2;
    std::size_t worst = 0;   // picture
    std::size_t judged = 0;  // by people
    double gain = 0;         // of P3, their mean
    double least_gain = 0;
    std::size_t worse = 0;  // of those by kWorse at least
};

Summary sum_up(const StabilityStudy& study, std::size_t recipe, std::size_t column) {
    Summary summary;
    for (std::size_t i = 0; i < study.pictures.size(); ++i) {
        const auto& held = study.pictures[i].held[recipe];
        if (column >= held.size()) continue;
        ++summary.pictures;
        summary.mean += held[column].mean;
        if (const auto gain = held[column].gain) {
            summary.least_gain = summary.judged == 0 ? *gain : std::min(summary.least_gain, *gain);
            ++summary.judged;
            summary.gain += *gain;
            if (*gain <= -kWorse) ++summary.worse;
        }
        if (held[column].least >= summary.least) continue;
        summary.least = held[column].least;
        summary.worst = i;
    }
    if (summary.pictures > 0) summary.mean /= static_cast<double>(summary.pictures);
    if (summary.judged > 0) summary.gain /= static_cast<double>(summary.judged);
    return summary;
}

std::string known_text(const StabilityStudy& study, std::size_t k, std::size_t recipe) {
    const double figure = study.knowns[k].known[recipe];
    return study.known[k].contour.pixels.empty() ? fixed(100 * figure, 2) + " %" : fixed(figure, 2);
}

std::vector<ToldRow> held_rows(const StabilityStudy& study) {
    std::vector<ToldRow> rows{{phrase("recipe")}};
    rows[0].insert(rows[0].end(), study.told.begin(), study.told.end());
    rows[0].push_back(phrase("worst start"));
    for (std::size_t c = 0; c < study.request.candidates.size(); ++c) {
        ToldRow row{study.request.candidates[c].name};
        Summary summary;
        for (std::size_t column = 0; column < study.columns.size(); ++column) {
            summary = sum_up(study, c, column);
            row.push_back(summary.pictures > 0 ? fixed(summary.mean, 2) : "");
        }
        row.push_back(summary.pictures > 0 ? fixed(summary.least, 2) : "");
        rows.push_back(std::move(row));
    }
    return rows;
}

// Nothing where people drew none of the pictures.
std::vector<ToldRow> stability_people_rows(const StabilityStudy& study) {
    std::vector<ToldRow> rows{{phrase("P3 against people")}};
    rows[0].insert(rows[0].end(), study.told.begin(), study.told.end());
    for (std::size_t c = 0; c < study.request.candidates.size(); ++c) {
        const std::string& name = study.request.candidates[c].name;
        ToldRow mean{phrase("{0}, mean change", name)}, least{phrase("{0}, worst page", name)};
        ToldRow worse{phrase("{0}, worse by {1}", name, numeral(kWorse))};
        bool judged = false;
        for (std::size_t column = 0; column < study.columns.size(); ++column) {
            const Summary summary = sum_up(study, c, column);
            const bool has = summary.judged > 0;
            judged = judged || has;
            mean.push_back(has ? fixed(summary.gain, 3) : "");
            least.push_back(has ? fixed(summary.least_gain, 3) : "");
            worse.push_back(has ? phrase("{0} of {1}", std::to_string(summary.worse), std::to_string(summary.judged)) : Phrase());
        }
        if (judged) rows.insert(rows.end(), {std::move(mean), std::move(least), std::move(worse)});
    }
    if (rows.size() == 1) rows.clear();
    return rows;
}

std::vector<ToldRow> known_rows(const StabilityStudy& study) {
    std::vector<ToldRow> rows{{phrase("recipe")}};
    for (const KnownPicture& known : study.known) rows[0].push_back(phrase(known.name));
    for (std::size_t c = 0; c < study.request.candidates.size(); ++c) {
        rows.push_back({study.request.candidates[c].name});
        for (std::size_t k = 0; k < study.known.size(); ++k) rows.back().push_back(known_text(study, k, c));
    }
    return rows;
}

std::string stability_recipe_json(const StabilityStudy& study, std::size_t recipe) {
    std::vector<std::string> columns, knowns, pictures;
    for (std::size_t column = 0; column < study.columns.size(); ++column) {
        const Summary summary = sum_up(study, recipe, column);
        if (summary.pictures == 0) continue;
        JsonObject json;
        json.add("change", study.columns[column]);
        json.add("f", summary.mean);
        json.add("worst_f", summary.least);
        json.add("worst_picture", study.request.subjects[summary.worst].name);
        if (summary.judged > 0) {
            json.add("p3_change", summary.gain);
            json.add("p3_worst_change", summary.least_gain);
            json.add("p3_worse", static_cast<double>(summary.worse));
            json.add("p3_pictures", static_cast<double>(summary.judged));
        }
        columns.push_back(json.text());
    }
    for (std::size_t k = 0; k < study.known.size(); ++k) {
        JsonObject json;
        json.add("picture", study.known[k].name.text);
        json.add(study.known[k].contour.pixels.empty() ? "ink" : "f", study.knowns[k].known[recipe]);
        knowns.push_back(json.text());
    }
    for (std::size_t i = 0; i < study.pictures.size(); ++i) {
        const auto& held = study.pictures[i].held[recipe];
        JsonObject json;
        json.add("picture", study.request.subjects[i].name);
        for (std::size_t column = 0; column < held.size(); ++column) json.add(study.columns[column], held[column].mean);
        pictures.push_back(json.text());
    }
    JsonObject json;
    json.add("recipe", study.request.candidates[recipe].name);
    json.add_raw("changes", json_array(columns));
    json.add_raw("known", json_array(knowns));
    json.add_raw("pictures", json_array(pictures));
    return json.text();
}

std::string whole_json(const StabilityStudy& study) {
    std::string text;
    for (std::size_t c = 0; c < study.request.candidates.size(); ++c) text += stability_recipe_json(study, c) + "\n";
    JsonObject whole;
    whole.add("pictures", static_cast<double>(study.pictures.size()));
    whole.add_raw("problems", json_text_array(study.problems));
    return text + whole.text() + "\n";
}

void carry_out(StabilityStudy& study, const StudyWatch& watch) {
    const std::size_t photos = study.pictures.size(), count = photos + study.knowns.size();
    work_through(study.request, watch, count, [&](std::size_t i) {
        Result& result = i < photos ? study.pictures[i] : study.knowns[i - photos];
        result = i < photos ? look_at(study.request, study.request.subjects[i]) : look_at(study.request, study.known[i - photos]);
        return result.problems;
    });
    for (const auto* results : {&study.pictures, &study.knowns})
        for (const Result& result : *results)
            study.problems.insert(study.problems.end(), result.problems.begin(), result.problems.end());
}

StudyFindings run_stability_study(const StudyRequest& request, const StudyWatch& watch) {
    StabilityStudy study(request);
    carry_out(study, watch);
    const std::vector<ToldRow> held = held_rows(study), people = stability_people_rows(study);
    StudyFindings findings;
    findings.text = told_table(held, request.language) + "\n" +
                    (people.empty() ? "" : told_table(people, request.language) + "\n") +
                    told_table(known_rows(study), request.language);
    findings.csv = told_csv(held);
    findings.json = whole_json(study);
    findings.problems = study.problems;
    findings.undone = SourceWords("{0} could not be compared:");
    return findings;
}

}  // namespace

extern const Study stability_study;
constinit const Study stability_study{
    .name = "stability",
    .details =
        "measures how much of a drawing stays the same when its picture changes: F between the recipe's drawings of the "
        "original and of the changed picture, which is mapped back onto the original, matched one to one within 0.75 percent of "
        "the diagonal; 1 if both are empty, 0 if one is. Columns are means over the pictures, each reduced to 500 pixels at "
        "most: JPEG 70 and 50 (quality, colour at half resolution), noise 10 (deviation in grey levels), shift (one pixel right "
        "and down), turn (one degree about the middle), crop (a twentieth off each side; the rest keeps its scale), half (half "
        "as many pixels each way), gamma 0.8, low and very low (contrast times 0.5 and 0.2 about middle grey), dark 0.3 and 0.1 "
        "(grey values times that), bright 1.2 (overexposed, cut off at white), start (four other seeds of each kmeans). After "
        "these come pictures with nothing to find, with the share of pixels that became line, and two discs, with the F of "
        "their circle: one 4 grey levels above its background with noise of 3, one that differs only in colour. --json also "
        "names the worst picture of each column. Where pictures of 500 pixels at most have contour maps, a second table shows "
        "how much P3 (see --study page) changes from the drawing of the original to that of the changed picture: the mean, the "
        "worst page, and the number of pages where it falls by 0.05 or more.",
    .needs_maps = false,
    .refuses = kAsItIs,
    .without = kDots,
    .besides = kRandomStart,
    .run = run_stability_study,
};

}  // namespace tactics
