// SPDX-License-Identifier: Apache-2.0
#include "studies/page.h"

#include <algorithm>
#include <array>

#include "filters/drawing_of.h"
#include "filters/list.h"
#include "studies/frontier.h"
#include "studies/picture.h"
#include "studies/work.h"
#include "tactics/job/make_pages.h"
#include "tactics/job/mending.h"
#include "tactics/job/mending_json.h"
#include "tactics/job/reading.h"
#include "tactics/layout/place.h"
#include "tactics/measure/evaluation.h"
#include "tactics/measure/lines.h"
#include "tactics/text/json.h"
#include "tactics/text/table.h"

namespace tactics {

namespace {

constexpr std::string_view kPerson = "simplest person";

PageTrial trial_of(const Drawing& page, const Consensus& people, const PictureInfo& info) {
    PageTrial trial;
    trial.tried = true;
    trial.shares = people.shares_of(cut_at(lines_of(page, info.width, info.height), 0));
    trial.lines = whole_lines(page);
    return trial;
}

PageTrial try_recipe_page(const StudyRequest& request, const Subject& subject, const Candidate& candidate,
                          const Consensus& people, const PictureInfo& info) {
    const double start = cpu_ms();
    ReadyRecipe ready = make_ready(request, subject, candidate);
    const Mended page =
        mend_for(*request.sheet.medium, ready.place.width, drawing_of(run(ready.recipe, std::move(ready.from))), false);
    const double end = cpu_ms();
    PageTrial trial = trial_of(page.drawing, people, info);
    trial.trust = page.told.trust;
    trial.page_ms = end - start;
    return trial;
}

PageTrial try_person_page(const StudyRequest& request, const MappedPicture& mapped) {
    if (mapped.truths.size() < 2) {
        PageTrial nobody;
        nobody.nobody = true;
        return nobody;
    }
    const std::size_t simplest = simplest_of(mapped.truths);
    const double width = place_on(request.sheet, aspect_of(mapped.info)).drawing.width;
    const Mended page = mend_for(*request.sheet.medium, width, drawing_of_person(mapped.truths[simplest], width), false);
    return trial_of(page.drawing, Consensus(others_than(mapped.truths, simplest)), mapped.info);
}

std::string trial_json(const std::string& picture, const PageTrial& trial, bool timed) {
    JsonObject json;
    json.add("picture", picture);
    json.add("p3", trial.shares.p3);
    json.add("p1", trial.shares.p1);
    if (trial.shares.r3) json.add("r3", *trial.shares.r3);
    if (trial.shares.main_object) json.add("main_object", *trial.shares.main_object);
    json.add("diagonals", trial.shares.diagonals);
    json.add("lines", static_cast<double>(trial.lines.lines));
    json.add("line_mm", trial.lines.length);
    json.add("loose_ends", static_cast<double>(trial.lines.loose_ends));
    json.add("whole_mm", trial.lines.whole);
    if (timed) json.add("page_ms", trial.page_ms);
    if (timed) json.add_raw("poor", trial.poor ? "true" : "false");
    if (trial.trust) json.add_raw("trust", trust_json(*trial.trust));
    return json.text();
}

std::string maker_json(const PageStudy& study, const PageMaker& maker) {
    const PageFigures figures = page_figures(maker);
    JsonObject json;
    json.add("recipe", maker.name);
    json.add("scored", static_cast<double>(figures.pages));
    if (figures.pages > 0) {
        json.add("p3", figures.p3);
        json.add("p1", figures.p1);
        if (figures.r3) json.add("r3", *figures.r3);
        if (figures.main_object) json.add("main_object", *figures.main_object);
        json.add("diagonals", figures.diagonals);
        json.add("lines", figures.lines);
        json.add("line_mm", figures.length);
        json.add("loose_ends", figures.loose_ends);
        json.add("whole", figures.whole);
        if (maker.timed) json.add("page_ms", figures.page_ms);
    }
    std::vector<std::string> pages;
    for (std::size_t i = 0; i < maker.trials.size(); ++i)
        if (maker.trials[i].tried) pages.push_back(trial_json(study.pictures[i], maker.trials[i], maker.timed));
    json.add_raw("pictures", json_array(pages));
    return json.text();
}

// A mean of the values that there are.
class Mean {
public:
    void add(double value) {
        sum_ += value;
        ++count_;
    }
    void add(const std::optional<double>& value) {
        if (value) add(*value);
    }
    std::optional<double> value() const {
        if (count_ == 0) return std::nullopt;
        return sum_ / static_cast<double>(count_);
    }

private:
    double sum_ = 0;
    std::size_t count_ = 0;
};

std::string cell(const std::optional<double>& value) { return value ? fixed(*value, 3) : ""; }

// The people's own page says whether a better one was to be had.
void find_poor(PageStudy& study) {
    const PageMaker& person = study.makers.back();
    for (PageMaker& maker : study.makers)
        for (std::size_t i = 0; i < maker.trials.size(); ++i) {
            PageTrial& trial = maker.trials[i];
            trial.poor = trial.tried && person.trials[i].tried && is_poor(trial.shares, person.trials[i].shares);
        }
}

}  // namespace

Drawing drawing_of_person(const PixelSet& lines, double width) {
    Image image = make_image(lines.width, lines.height, 1, width / lines.width, 255);
    for (const std::uint32_t pixel : lines.pixels) image.pixels[pixel] = 0;
    return drawing_of(run(parse_recipe("trace spur=0 bridge=0 shortest=0\nsimplify\n", "people", filters()), std::move(image)));
}

PageFigures page_figures(const PageMaker& maker) {
    PageFigures figures;
    Mean p3, p1, r3, main_object, diagonals, whole;
    std::vector<double> lines, length, loose_ends, page_ms;
    for (const PageTrial& trial : maker.trials) {
        if (!trial.tried) continue;
        ++figures.pages;
        p3.add(trial.shares.p3);
        p1.add(trial.shares.p1);
        r3.add(trial.shares.r3);
        main_object.add(trial.shares.main_object);
        diagonals.add(trial.shares.diagonals);
        whole.add(trial.lines.length > 0 ? trial.lines.whole / trial.lines.length : 0);
        lines.push_back(static_cast<double>(trial.lines.lines));
        length.push_back(trial.lines.length);
        loose_ends.push_back(static_cast<double>(trial.lines.loose_ends));
        page_ms.push_back(trial.page_ms);
    }
    figures.p3 = p3.value().value_or(0);
    figures.p1 = p1.value().value_or(0);
    figures.r3 = r3.value();
    figures.main_object = main_object.value();
    figures.diagonals = diagonals.value().value_or(0);
    figures.whole = whole.value().value_or(0);
    figures.lines = median_of(std::move(lines));
    figures.length = median_of(std::move(length));
    figures.loose_ends = median_of(std::move(loose_ends));
    figures.page_ms = median_of(std::move(page_ms));
    return figures;
}

std::vector<ToldRow> page_rows(const PageStudy& study) {
    std::vector<ToldRow> rows{{phrase("recipe"), phrase("P3"), phrase("P1"), phrase("R3"), phrase("main object"),
                               phrase("diagonals"), phrase("lines"), phrase("line mm"), phrase("loose ends"), phrase("whole"),
                               phrase("CPU ms"), phrase("pages"), phrase("failed")}};
    for (const PageMaker& maker : study.makers) {
        const PageFigures figures = page_figures(maker);
        const auto failed = std::count_if(maker.trials.begin(), maker.trials.end(),
                                          [](const PageTrial& trial) { return !trial.tried && !trial.nobody; });
        ToldRow row{maker.timed ? Phrase(maker.name) : phrase("simplest person")};
        if (figures.pages > 0)
            row.insert(row.end(),
                       {fixed(figures.p3, 3), fixed(figures.p1, 3), cell(figures.r3), cell(figures.main_object),
                        fixed(figures.diagonals, 2), fixed(figures.lines, 0), fixed(figures.length, 0),
                        fixed(figures.loose_ends, 0), fixed(figures.whole, 2), maker.timed ? fixed(figures.page_ms, 1) : ""});
        row.resize(rows.front().size() - 2);
        row.insert(row.end(), {std::to_string(figures.pages), std::to_string(failed)});
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<ToldRow> trust_rows(const PageStudy& study) {
    constexpr std::array kBelow{0.65, 0.75, 1.01};  // of pages that are not told; so that each line has some
    std::vector<ToldRow> rows{{phrase("recipe"), phrase("agreement expected"), phrase("pages"), phrase("poor"),
                               phrase("P3 expected"), phrase("P3"), phrase("R3 expected"), phrase("R3")}};
    const auto add = [&](const PageMaker& maker, const Phrase& expected, const auto& is_in) {
        Mean expected_line, line, expected_found, found;
        std::size_t pages = 0, poor = 0;
        for (const PageTrial& trial : maker.trials) {
            if (!trial.tried || !trial.trust || !is_in(*trial.trust)) continue;
            ++pages;
            poor += trial.poor ? 1 : 0;
            expected_line.add(trial.trust->line);
            line.add(trial.shares.p3);
            if (!trial.shares.r3) continue;
            expected_found.add(trial.trust->found);
            found.add(trial.shares.r3);
        }
        if (pages > 0)
            rows.push_back({maker.name, expected, std::to_string(pages), std::to_string(poor), cell(expected_line.value()),
                            cell(line.value()), cell(expected_found.value()), cell(found.value())});
    };
    for (const PageMaker& maker : study.makers) {
        add(maker, phrase("too little, told"), [](const Trust& trust) { return is_doubtful(trust); });
        for (std::size_t i = 0; i < kBelow.size(); ++i)
            add(maker, i + 1 < kBelow.size() ? phrase("under {0}", fixed_numeral(kBelow[i], 2)) : phrase("more"),
                [&](const Trust& trust) {
                    return !is_doubtful(trust) && trust.agreement() < kBelow[i] && (i == 0 || trust.agreement() >= kBelow[i - 1]);
                });
    }
    return rows;
}

std::string page_json(const PageStudy& study) {
    std::string text;
    for (const PageMaker& maker : study.makers) text += maker_json(study, maker) + "\n";
    return text + study_json("page", study.pictures.size(), study.problems);
}

Plot page_plot(const PageStudy& study, bool recall) {
    Plot plot{recall ? "Agreed contours drawn, against time" : "Line that people agree on, against time",
              {"ms for a page", true},
              {recall ? "R3, share of agreed contours" : "P3, share of the line", false},
              {},
              {}};
    std::optional<double> person;
    for (const PageMaker& maker : study.makers) {
        const PageFigures figures = page_figures(maker);
        if (figures.pages == 0) continue;
        const std::optional<double> share = recall ? figures.r3 : figures.p3;
        if (!share) continue;
        if (maker.timed)
            plot.marks.push_back({maker.name, figures.page_ms, *share, PlotSymbol::ring});
        else
            person = share;
    }
    join_frontier(plot);
    if (person) add_level(plot, std::string(kPerson), *person);
    return plot;
}

namespace {

std::vector<StudyChart> page_charts(const PageStudy& study, const StudyRequest& request) {
    std::vector<StudyChart> charts;
    if (request.charts.empty()) return charts;
    for (const bool recall : {false, true}) {
        StudyChart chart{recall ? "r3" : "p3", page_plot(study, recall)};
        if (chart.plot.marks.empty())
            chart.missing =
                phrase("{0}: not drawn, as no picture has what it would show", with_word(request.charts.front(), chart.word));
        if (chart.missing.empty() || !request.quiet) charts.push_back(std::move(chart));
    }
    return charts;
}

StudyFindings run_page_study(const StudyRequest& request, const StudyWatch& watch) {
    PageStudy study;
    const std::size_t pictures = request.subjects.size();
    for (const Subject& subject : request.subjects) study.pictures.push_back(subject.name);
    for (const Candidate& candidate : request.candidates)
        study.makers.push_back({candidate.name, true, std::vector<PageTrial>(pictures)});
    study.makers.push_back({std::string(kPerson), false, std::vector<PageTrial>(pictures)});
    study.problems = try_all(request, watch, true, [&](std::size_t i, const MappedPicture& mapped) {
        study.makers.back().trials[i] = try_person_page(request, mapped);
        return [&, i, info = mapped.info, people = Consensus(mapped.truths)](std::size_t c) {
            study.makers[c].trials[i] = try_recipe_page(request, request.subjects[i], request.candidates[c], people, info);
        };
    });
    find_poor(study);
    const std::vector<ToldRow> rows = page_rows(study), trust = trust_rows(study);
    StudyFindings findings;
    findings.text = told_table(rows, request.language) + (trust.size() > 1 ? "\n" + told_table(trust, request.language) : "");
    findings.csv = told_csv(rows);
    findings.json = page_json(study);
    findings.problems = study.problems;
    findings.undone = SourceWords("{0} could not be drawn:");
    findings.charts = page_charts(study, request);
    return findings;
}

}  // namespace

extern const Study page_study;
constinit const Study page_study{
    .name = "page",
    .details =
        "scores the lines of the page as convert makes it, mended. P3 and P1 are the shares of its line that run within 0.75 "
        "percent of the diagonal of a line that at least 3 people, or at least 1, drew; R3 is the share of the lines of at "
        "least 3 people that the page has; main object is the share of the outline of the largest thing that each person drew "
        "whole; diagonals is the length of line in picture diagonals. An end of a line is loose if it is not within 4 mm of "
        "another line, of its own other end or of the edge of the drawing; whole is the share of line without loose ends. "
        "Lines, mm, loose ends and CPU ms (from the picture to the mended drawing) are medians, the others means. The row "
        "simplest person scores against the others the page drawn by the person with the fewest regions. --chart draws P3 and "
        "R3 against time: chart-p3.pdf, chart-r3.pdf. A recipe that predicts the quality of its pages has a second table: "
        "predicted and actual P3 and R3, grouped by the harmonic mean of the two predictions, and the number of poor pages. A "
        "page is poor if less than two thirds of its line is agreed on, or if it has less than 0.45 of the agreed lines and "
        "less than 0.6 of the main object; in either case only if the simplest person is better by 0.1.",
    .refuses = kAsItIs,
    .without = kDotsAndRegions,
    .charted = recipes_and_person,
    .run = run_page_study,
};

}  // namespace tactics
