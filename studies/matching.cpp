// SPDX-License-Identifier: Apache-2.0
#include "studies/matching.h"

#include <algorithm>

#include "filters/drawing_of.h"
#include "filters/list.h"
#include "print/raster.h"
#include "studies/matching_report.h"
#include "studies/picture.h"
#include "studies/work.h"
#include "tactics/error.h"
#include "tactics/job/make_pages.h"
#include "tactics/job/reading.h"
#include "tactics/job/workers.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/place.h"
#include "tactics/measure/lines.h"
#include "tactics/measure/random.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr int kReaders = 50;        // 1000 trials of 20 pictures: an interval of at most 0.06
constexpr int kRandomReaders = 60;  // each with other parameters
constexpr int kOtherReaders = 10;   // alike but for chance, of each that is not the usual one
constexpr std::size_t kLargestSet = 20;
constexpr int kCells = 127;        // of 0.5 mm on 2.5 in
constexpr int kPixelsPerCell = 4;  // 0.125 mm, a quarter of the thinnest edge that is ever printed

struct Sheets {                   // of one picture
    std::vector<Relief> reliefs;  // by candidate
    std::vector<SheetFacts> facts;
    std::vector<Phrase> problems;
};

// The middle of the picture, as long as wide: the study's sheets were squares, and the shape must not tell them apart.
void cut_square(Recipe& recipe, const PictureInfo& info) {
    if (info.width == info.height) return;
    const double part = 50 * (1 - static_cast<double>(std::min(info.width, info.height)) / std::max(info.width, info.height));
    const std::string line = info.width > info.height ? "crop left=" + to_text(part) + " right=" + to_text(part)
                                                      : "crop top=" + to_text(part) + " bottom=" + to_text(part);
    recipe.steps.insert(recipe.steps.begin(), parse_step(line, "--study matching", filters()));
}

PixelSet middle_square(const PixelSet& truth) {
    const int side = std::min(truth.width, truth.height);
    const int left = (truth.width - side) / 2, top = (truth.height - side) / 2;
    PixelSet square{side, side, {}};
    for (const std::uint32_t pixel : truth.pixels) {
        const int x = static_cast<int>(pixel) % truth.width - left, y = static_cast<int>(pixel) / truth.width - top;
        if (x >= 0 && y >= 0 && x < side && y < side) square.pixels.push_back(static_cast<std::uint32_t>(y * side + x));
    }
    return square;
}

Relief relief_of(const Page& page) {
    Relief relief{kCells, page.width / kCells, std::vector<float>(static_cast<std::size_t>(kCells) * kCells, 0.0f)};
    const int side = kCells * kPixelsPerCell;
    int y = 0;
    draw_rows(page, pixels_across(page, side, side, "evaluate"), [&](const std::uint8_t* row) {
        float* cells = relief.raised.data() + static_cast<std::size_t>(y++ / kPixelsPerCell) * kCells;
        for (int x = 0; x < side; ++x)
            if ((row[x / 8] & (0x80 >> (x % 8))) != 0) cells[x / kPixelsPerCell] += 1.0f / (kPixelsPerCell * kPixelsPerCell);
    });
    return relief;
}

// As convert makes them for that sheet.
class SheetMaker {
public:
    SheetMaker(const StudyRequest& request, const Subject& subject)
        : request_(request), source_(open_picture(request, subject)), info_(inspect_picture(source_)), reading_(source_) {
        for (const auto& path : subject.truths) truths_.push_back(middle_square(read_truth(path, info_.width, info_.height)));
    }

    void make(const Candidate& candidate, Sheets& sheets) {
        const Medium& medium = *request_.sheet.medium;
        const Recipe base = candidate.chain.base ? *candidate.chain.base : find_recipe(choose(reading_).recipe, "auto");
        Recipe recipe = fit_to(medium, finish(candidate.chain, base));
        if (!draws_whole(recipe))
            throw Error(Fault::failed, "",
                        phrase("a part of the picture is cut off, but a sheet is of its whole middle; leave out crop"));
        cut_square(recipe, info_);
        const Kept kept = kept_by(recipe);
        const Rect place = place_on(request_.sheet, aspect_of(info_) * kept.width / kept.height).drawing;
        const Drawing drawing = drawing_of(tactics::run(recipe, read_for(recipe, place, reading_)));
        const Page page = lay_out(drawing, request_.sheet);
        SheetFacts facts;
        facts.length = total_stroke_length(page);
        Relief relief = relief_of(page);
        for (const float share : relief.raised) facts.ink += share;
        facts.ink /= static_cast<double>(relief.raised.size());
        if (!truths_.empty()) {
            const int side = truths_.front().width;
            facts.contours = score_at_levels(lines_of(drawing, side, side), truths_).back();
        }
        sheets.facts.push_back(facts);
        sheets.reliefs.push_back(std::move(relief));
    }

private:
    const StudyRequest& request_;
    Source source_;
    PictureInfo info_;
    Reading reading_;
    std::vector<PixelSet> truths_;
};

// A picture that one recipe cannot make a sheet of is left out for all: the sets must be the same.
Sheets make_sheets(const StudyRequest& request, const Subject& subject) {
    Sheets sheets;
    const Candidate* at = nullptr;
    const Failure failure = failure_of(subject.picture, [&] {
        SheetMaker maker(request, subject);
        for (const Candidate& candidate : request.candidates) {
            at = &candidate;
            maker.make(candidate, sheets);
        }
    });
    if (!failure.text.empty()) sheets.problems.push_back(at == nullptr ? failure.text : of_recipe(at->name, failure.text));
    return sheets;
}

// As few sets as the largest allows, as equal as can be.
std::vector<std::size_t> sets_of(std::size_t pictures) {
    const std::size_t count = (pictures + kLargestSet - 1) / kLargestSet;
    std::vector<std::size_t> sets;
    for (std::size_t i = 0; i < count; ++i) sets.push_back(pictures * (i + 1) / count - pictures * i / count);
    return sets;
}

using Collections = std::vector<std::vector<std::vector<Relief>>>;  // by recipe and set

// The answers of all sets with one reader: how often each sheet of a set was taken for each other.
using Tables = std::vector<std::vector<std::size_t>>;

Tables ask(const std::vector<std::vector<Relief>>& sets, const FingertipReader& reader, int readers, std::uint64_t seed) {
    Tables tables;
    for (const auto& set : sets) {
        const Answers answers = match_sheets(set, reader, readers, seed_of(seed, tables.size()));
        auto& taken = tables.emplace_back(set.size() * set.size(), 0);
        for (std::size_t i = 0; i < answers.taken.size(); ++i) ++taken[i % set.size() * set.size() + answers.taken[i]];
    }
    return tables;
}

void keep_answers(MatchedRecipe& recipe, const std::vector<std::size_t>& sets, const Tables& tables) {
    std::size_t first = 0;
    for (std::size_t set = 0; set < sets.size(); first += sets[set++])
        for (std::size_t i = 0; i < tables[set].size(); ++i) {
            const std::size_t picture = i / sets[set], answer = i % sets[set], times = tables[set][i];
            if (picture == answer)
                recipe.sheets[first + picture].hits = times;
            else if (times > 0)
                recipe.mistakes.push_back({first + picture, first + answer, times});
        }
    std::stable_sort(recipe.mistakes.begin(), recipe.mistakes.end(),
                     [](const Mistake& a, const Mistake& b) { return a.times > b.times; });
}

double rate_of_matching(const std::vector<std::size_t>& sets, const Tables& tables, int readers) {
    std::size_t hits = 0, pictures = 0;
    for (std::size_t set = 0; set < sets.size(); pictures += sets[set++])
        for (std::size_t i = 0; i < sets[set]; ++i) hits += tables[set][i * (sets[set] + 1)];
    return static_cast<double>(hits) / (static_cast<double>(pictures) * readers);
}

std::uint64_t seed_in(const StudyRequest& request) { return static_cast<std::uint64_t>(request.settings.whole("seed")); }

// Recipes are felt by the same readers with the same luck, so that a difference is not theirs.
void match(MatchingStudy& study, const Collections& collections, const StudyRequest& request) {
    const std::size_t changed = study.changed_readers.size(), rounds = 1 + changed + study.random_readers.size();
    share_out(rounds * study.recipes.size(), request.workers, [&](std::size_t task) {
        const std::size_t round = task / study.recipes.size();
        MatchedRecipe& recipe = study.recipes[task % study.recipes.size()];
        const auto& sets = collections[task % study.recipes.size()];
        const std::uint64_t seed = seed_of(seed_in(request), round);
        if (round == 0) {
            keep_answers(recipe, study.sets, ask(sets, study.reader, study.readers, seed));
        } else if (round <= changed) {
            const Tables tables = ask(sets, study.changed_readers[round - 1].reader, kOtherReaders, seed);
            recipe.changed[round - 1] = rate_of_matching(study.sets, tables, kOtherReaders);
        } else {
            const Tables tables = ask(sets, study.random_readers[round - 1 - changed], kOtherReaders, seed);
            recipe.random[round - 1 - changed] = rate_of_matching(study.sets, tables, kOtherReaders);
        }
    });
}

// Each parameter at either end of its range, and the places also in between, for they decide most.
std::vector<ChangedReader> changed_readers() {
    std::vector<ChangedReader> readers;
    const FingertipReader usual;
    for (const ReaderRange& range : reader_ranges()) {
        std::vector<double> values{range.least, range.most};
        if (range.name.text == "places") values = {range.least, 8, 20, range.most};
        for (const double value : values) {
            if (range.get(usual) == value) continue;
            readers.push_back({phrase("{0} {1}", phrase(range.name), numeral(value)), usual});
            range.set(readers.back().reader, value);
        }
    }
    return readers;
}

MatchingStudy study_matching(const StudyRequest& request, const StudyWatch& watch) {
    std::vector<Sheets> all(request.subjects.size());
    work_through(request, watch, all.size(), [&](std::size_t i) {
        all[i] = make_sheets(request, request.subjects[i]);
        return all[i].problems;
    });

    MatchingStudy study;
    study.readers = kReaders;
    study.changed_readers = changed_readers();
    study.problems = request.problems;
    for (const Candidate& candidate : request.candidates) study.recipes.push_back({candidate.name, {}, {}, {}, {}});
    std::vector<Sheets*> good;
    for (std::size_t i = 0; i < all.size(); ++i) {
        study.problems.insert(study.problems.end(), all[i].problems.begin(), all[i].problems.end());
        if (!all[i].problems.empty()) continue;
        good.push_back(&all[i]);
        study.pictures.push_back(request.subjects[i].name);
        for (std::size_t c = 0; c < study.recipes.size(); ++c) study.recipes[c].sheets.push_back(all[i].facts[c]);
    }
    if (good.size() < 2)
        throw Error(
            Fault::failed, "--study matching",
            good.empty()
                ? phrase("a sheet is looked for among others, so at least 2 pictures that can be read are needed; here are none")
                : phrase("a sheet is looked for among others, so at least 2 pictures that can be read are needed; here is one"));
    study.sets = sets_of(good.size());
    Collections collections(study.recipes.size());
    for (std::size_t c = 0; c < collections.size(); ++c) {
        auto sheet = good.begin();
        for (const std::size_t size : study.sets) {
            auto& set = collections[c].emplace_back();
            for (std::size_t i = 0; i < size; ++i) set.push_back(std::move((*sheet++)->reliefs[c]));
        }
        study.recipes[c].changed.resize(study.changed_readers.size());
        study.recipes[c].random.resize(kRandomReaders);
    }
    for (int i = 0; i < kRandomReaders; ++i)
        study.random_readers.push_back(random_reader(seed_of(seed_in(request) ^ 0xf1a9e2, static_cast<std::uint64_t>(i))));
    match(study, collections, request);
    return study;
}

StudyFindings run_matching_study(const StudyRequest& request, const StudyWatch& watch) {
    const MatchingStudy study = study_matching(request, watch);
    StudyFindings findings;
    findings.text = matching_text(study, request.language);
    findings.csv = matching_csv(study);
    findings.json = matching_json(study);
    findings.problems = study.problems;
    findings.undone = SourceWords("{0} could not be used:");
    return findings;
}

constexpr Option kOptions[] = {{.name = "seed",
                                .type = Option::Type::whole,
                                .fallback = 1,
                                .min = 0,
                                .max = 1e9,
                                .summary = "another number, other simulated readers"}};
constexpr SourceWords kSquares = "the sheets of --study matching are squares of 2.5 in, each made once";
constexpr Refusal kMatchingRefuses[] = {{"paper", kSquares}, {"margin", kSquares}, {"sweep", kSquares}};
constexpr std::string_view kMatchingRecipes[] = {"none",         "kmeans", "sobel", "kmeans-sobel",
                                                 "sobel-kmeans", "photo",  "auto"};  // the paper's five first

}  // namespace

std::size_t MatchedRecipe::hits() const {
    std::size_t sum = 0;
    for (const SheetFacts& sheet : sheets) sum += sheet.hits;
    return sum;
}

std::size_t MatchedRecipe::empty() const {
    return static_cast<std::size_t>(
        std::count_if(sheets.begin(), sheets.end(), [](const SheetFacts& sheet) { return sheet.ink == 0; }));
}

double MatchingStudy::chance() const { return static_cast<double>(sets.size()) / static_cast<double>(pictures.size()); }

extern const Study matching_study;
constinit const Study matching_study{
    .name = "matching",
    .details =
        "repeats the pilot study of TACTICS with simulated readers. Each picture becomes a square sheet of 2.5 in; a simulated "
        "fingertip with limited acuity, sense of place and memory then looks for each sheet among all of its kind, in sets of "
        "at most 20. Matched is how often it finds the sheet; the 95 percent interval covers chance among readers, not among "
        "pictures. Random readers is the median rate of 60 readers with random parameters; the rates with one parameter changed "
        "follow. It is a simulation: the reader has not been validated on people.",
    .needs_maps = false,
    .options = kOptions,
    .no_options = SourceWords("nothing is left to chance here"),
    .refuses = kMatchingRefuses,
    .paper = "2.5x2.5in",
    .recipes = kMatchingRecipes,
    .besides = kRandomStart,
    .run = run_matching_study,
};

}  // namespace tactics
