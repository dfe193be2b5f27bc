// SPDX-License-Identifier: Apache-2.0
#include "studies/needed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/list.h"
#include "studies/picture.h"
#include "studies/work.h"
#include "tactics/error.h"
#include "tactics/geometry/evidence.h"
#include "tactics/job/reading.h"
#include "tactics/job/workers.h"
#include "tactics/layout/place.h"
#include "tactics/measure/lines.h"
#include "tactics/measure/score.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kAll = std::numeric_limits<double>::infinity();
constexpr double kAllLevels = 256;
constexpr std::string_view kAsMade = " as it is";  // the name of a mark
enum DialIndex : std::size_t { kLevels, kDpi, kStrokes, kDials };

std::vector<NeededDial> dials_for(const Medium& medium) {
    std::vector<NeededDial> dials{{"grey levels", phrase("grey levels"), "levels", {2, 3, 4, 6, 8, 16, kAllLevels}},
                                  {"dots per inch", phrase("dots per inch"), "dpi", {10, 15, 20, 30, 45, 60, 90}},
                                  {"strokes", phrase("strokes"), "strokes", {1, 2, 5, 10, 20, 50, 100, kAll}}};
    std::erase_if(dials[kDpi].values, [&](double dpi) { return dpi > medium.dpi; });  // it shows no more
    return dials;
}

// The first place where the picture ends: what is put there is seen by the edges. Behind the steps that only cut and scale
// in a recipe without edges.
std::size_t before_edges(const Recipe& recipe) {
    for (std::size_t i = 0; i < recipe.steps.size(); ++i)
        if (recipe.steps[i].filter->gives == static_cast<Kinds>(Kind::edges)) return i;
    std::size_t i = 0;
    while (i < recipe.steps.size() && (recipe.steps[i].filter->name == "resample" || recipe.steps[i].filter->name == "crop")) ++i;
    return i;
}

Step* resampling(Recipe& recipe) {
    for (Step& step : recipe.steps)
        if (step.filter->name == "resample") return &step;
    return nullptr;
}

// One picture and its maps.
class Trials {
public:
    Trials(const StudyRequest& request, const Subject& subject)
        : request_(request),
          source_(open_picture(request, subject)),
          info_(inspect_picture(source_)),
          reading_(source_),
          place_(place_on(request.sheet, aspect_of(info_)).drawing) {
        if (subject.truths.empty())
            throw Error(Fault::failed, "",
                        phrase("it has no contour map; add {0}_gt1.png, or take the picture away", subject.name));
        for (const auto& path : subject.truths) truths_.push_back(read_truth(path, info_.width, info_.height));
    }

    // By dial; without values where the recipe draws no strokes.
    std::vector<NeededCurve> curves(const Candidate& candidate, const std::vector<NeededDial>& dials, std::string& chosen) {
        Recipe base = candidate.chain.base ? *candidate.chain.base : find_recipe(choose(reading_).recipe, "auto");
        chosen = base.name;
        const Recipe recipe = fit_to(*request_.sheet.medium, finish(candidate.chain, std::move(base)));
        if (!draws_whole(recipe))
            throw Error(Fault::failed, "",
                        phrase("only a part of the picture is left, which no contour map fits; leave out crop"));
        const Artwork whole = tactics::run(recipe, read_for(recipe, place_, reading_));
        const double own_f = f_of(whole);
        std::vector<NeededCurve> curves(kDials);
        for (NeededCurve& curve : curves) curve.own_f = own_f;
        turn_levels(recipe, dials[kLevels], curves[kLevels]);
        turn_dpi(recipe, dials[kDpi], curves[kDpi]);
        if (const auto* drawing = std::get_if<Drawing>(&whole)) turn_strokes(*drawing, dials[kStrokes], curves[kStrokes]);
        return curves;
    }

private:
    // Of all that is drawn, as it would be printed.
    double f_of(const Artwork& artwork) const {
        EdgeMap lines = lines_of(artwork, info_.width, info_.height);
        for (float& strength : lines.strength) strength = strength > 0 ? levels().front() : 0;
        return score_at_levels(lines, truths_).back().f();
    }

    void turn_levels(const Recipe& recipe, const NeededDial& dial, NeededCurve& curve) {
        curve.own = kAllLevels;
        const Image grey = to_grey(read_for(recipe, place_, reading_));
        for (const double levels : dial.values) {
            Recipe turned = recipe;
            if (levels < kAllLevels)
                turned.steps.insert(turned.steps.begin() + static_cast<std::ptrdiff_t>(before_edges(recipe)),
                                    parse_step("kmeans k=" + to_text(levels), "--study needed", filters()));
            curve.f.push_back(f_of(tactics::run(turned, grey)));
        }
    }

    // Below what resample takes, the picture is read that small.
    void turn_dpi(Recipe recipe, const NeededDial& dial, NeededCurve& curve) {
        Step& step = *resampling(recipe);  // every finished recipe has one
        const double least = std::find_if(step.filter->options.begin(), step.filter->options.end(), [](const Option& option) {
                                 return option.name == "dpi";
                             })->min;
        curve.most = info_.width * kMmPerInch / place_.width;  // it is never enlarged
        curve.own = std::min(curve.most, step.settings.number("dpi"));
        for (const double dpi : dial.values) {
            step.settings.set("dpi", to_text(std::max(least, dpi)), "--study needed", "resample");
            Image image;
            if (dpi < least) {
                const double longer = std::max(place_.width, place_.height) / kMmPerInch * dpi;
                image = reading_.take({std::max(1, static_cast<int>(std::lround(longer))), uses_colour(recipe)});
                image.mm_per_pixel = place_.width / image.width;
            } else {
                image = read_for(recipe, place_, reading_);
            }
            curve.f.push_back(f_of(tactics::run(recipe, std::move(image))));
        }
    }

    void turn_strokes(const Drawing& drawing, const NeededDial& dial, NeededCurve& curve) {
        const std::vector<std::size_t> order = by_evidence(drawing.strokes);
        curve.own = curve.most = static_cast<double>(order.size());
        for (const double count : dial.values) {
            if (!curve.f.empty() && dial.values[curve.f.size() - 1] >= curve.most) {
                curve.f.push_back(curve.f.back());
                continue;
            }
            Drawing fewer = drawing;
            fewer.strokes.clear();
            for (const std::size_t i : order)
                if (static_cast<double>(fewer.strokes.size()) < count) fewer.strokes.push_back(drawing.strokes[i]);
            curve.f.push_back(f_of(fewer));
        }
    }

    const StudyRequest& request_;
    Source source_;
    PictureInfo info_;
    Reading reading_;
    Rect place_;
    std::vector<PixelSet> truths_;
};

struct PictureRows {
    std::vector<std::vector<NeededCurve>> curves;  // by candidate; empty: it failed
    std::vector<std::string> chosen;
    std::vector<Phrase> problems;
};

PictureRows try_picture(const StudyRequest& request, const Subject& subject, const std::vector<NeededDial>& dials) {
    PictureRows rows;
    rows.curves.resize(request.candidates.size());
    rows.chosen.resize(request.candidates.size());
    const Failure failure = failure_of(subject.picture, [&] {
        Trials trials(request, subject);
        for (std::size_t c = 0; c < request.candidates.size(); ++c) {
            const Candidate& candidate = request.candidates[c];
            const Failure problem =
                failure_of(subject.picture, [&] { rows.curves[c] = trials.curves(candidate, dials, rows.chosen[c]); });
            if (!problem.text.empty()) rows.problems.push_back(of_recipe(candidate.name, problem.text));
        }
    });
    if (!failure.text.empty()) rows.problems.push_back(failure.text);
    return rows;
}

NeededStudy try_pictures(const StudyRequest& request, const StudyWatch& watch) {
    NeededStudy study;
    study.dials = dials_for(*request.sheet.medium);
    study.problems = request.problems;
    study.tried = request.subjects.size();
    std::vector<PictureRows> all(study.tried);
    work_through(request, watch, study.tried, [&](std::size_t i) {
        all[i] = try_picture(request, request.subjects[i], study.dials);
        return all[i].problems;
    });
    for (std::size_t c = 0; c < request.candidates.size(); ++c) {
        NeededRecipe& recipe = study.recipes.emplace_back();
        recipe.name = request.candidates[c].name;
        recipe.curves.resize(kDials);
        recipe.pictures.resize(kDials);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].curves[c].empty()) continue;
            if (!request.candidates[c].chain.base) recipe.chosen.push_back(all[i].chosen[c]);
            for (std::size_t dial = 0; dial < kDials; ++dial) {
                if (all[i].curves[c][dial].f.empty()) continue;
                recipe.curves[dial].push_back(std::move(all[i].curves[c][dial]));
                recipe.pictures[dial].push_back(request.subjects[i].name);
            }
        }
    }
    for (const PictureRows& rows : all) study.problems.insert(study.problems.end(), rows.problems.begin(), rows.problems.end());
    return study;
}

// The mean curve of each recipe, and where it is by itself.
Plot needed_plot(const NeededStudy& study, std::size_t dial) {
    const NeededDial& turned = study.dials[dial];
    Plot plot{"Contours found, by " + turned.name, {turned.name, true}, {"F of contours", false}, {}, {}};
    for (const NeededRecipe& recipe : study.recipes) {
        if (recipe.curves[dial].empty()) continue;
        const NeededSummary summary = summary_of(recipe.curves[dial], turned.values);
        PlotCurve curve{recipe.name, {}};
        for (std::size_t i = 0; i < turned.values.size(); ++i)
            if (std::isfinite(turned.values[i])) curve.points.push_back({turned.values[i], summary.mean_f[i]});
        plot.curves.push_back(std::move(curve));
        if (summary.own.middle > 0) plot.marks.push_back({recipe.name + std::string(kAsMade), summary.own.middle, summary.own_f});
    }
    return plot;
}

std::vector<std::string> curves_and_marks(std::span<const Candidate> candidates) {
    std::vector<std::string> names;
    for (const Candidate& candidate : candidates)
        names.insert(names.end(), {candidate.name, candidate.name + std::string(kAsMade)});
    return names;
}

StudyFindings run_needed_study(const StudyRequest& request, const StudyWatch& watch) {
    const NeededStudy study = try_pictures(request, watch);
    StudyFindings findings;
    findings.text = needed_text(study, request.language);
    findings.json = needed_json(study);
    findings.problems = study.problems;
    for (std::size_t dial = 0; dial < study.dials.size(); ++dial) {
        StudyChart chart{study.dials[dial].word, needed_plot(study, dial)};
        if (chart.plot.curves.empty())
            chart.missing = phrase("there is no chart of {0}: no recipe here draws any", study.dials[dial].told);
        findings.charts.push_back(std::move(chart));
    }
    return findings;
}

constexpr SourceWords kOwnDials = "the study needed turns dials of its own and gives text or --json";
constexpr Refusal kNeededRefuses[] = {{"sweep", kOwnDials}, {"csv", kOwnDials}};
constexpr std::string_view kNeededRecipes[] = {"auto"};

}  // namespace

extern const Study needed_study;
constinit const Study needed_study{
    .name = "needed",
    .details =
        "turns one dial at a time, by default for recipe auto: the grey levels that K-means leaves before edges are found (256: "
        "all greys), the dots per inch of the page at which the recipe works, and the strokes kept, the strongest and longest "
        "first. F is that of the whole drawing. Enough is the smallest value for a picture whose F is within 1 percent of the "
        "best on that dial. The table gives the value that is enough for a quarter, half and three quarters of the pictures, "
        "the median that the recipe uses by default, on how many pictures that is more than needed, and the mean F at each "
        "value. --chart writes a page for each dial: chart-levels.pdf, chart-dpi.pdf, chart-strokes.pdf.",
    .refuses = kNeededRefuses,
    .recipes = kNeededRecipes,
    .charted = curves_and_marks,
    .run = run_needed_study,
};

}  // namespace tactics
