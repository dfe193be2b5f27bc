// SPDX-License-Identifier: Apache-2.0
// The description of a study, which tests recipes on a folder of pictures. Each study has one file and one line in list.inc; the
// help, the checks of the command line and its completion read these descriptions.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/job/recipe_wish.h"
#include "tactics/layout/sheet.h"
#include "tactics/measure/truth.h"
#include "tactics/option.h"
#include "tactics/plot.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A recipe to be tried, at each setting of the sweep; at one if the sweep does not concern it.
struct Candidate {
    std::string name;
    std::vector<std::string> settings;  ///< "k=3"; one empty text without a sweep
    std::vector<Recipe> recipes;        ///< by setting; none: chosen for each picture (auto)
    RecipeWish chain;
};

/// The request of a study, complete and checked before the first picture is opened.
struct StudyRequest {
    std::vector<Subject> subjects;
    std::vector<Phrase> problems;  ///< of the folders, one line each
    std::vector<Candidate> candidates;
    Sheet sheet;
    Settings settings{std::span<const Option>()};  ///< of the study's own options
    std::vector<std::string> charts;               ///< the files that its charts go to
    std::vector<std::string> allowed;              ///< of kAskedFormats: the pictures are trusted
    int workers = 0;                               ///< 0: as many as there are cores
    bool quiet = false;                            ///< print only the table and errors
    std::string language = "en";                   ///< a tag of BCP 47: of the tables' words
};

/// The observer of a running study. Called from any thread, one at a time.
struct StudyWatch {
    std::function<void(std::size_t done, std::size_t all)> goes_on = {};  ///< at the beginning, and after each picture
    std::function<void(const Phrase& problem)> tell = {};                 ///< one line, as soon as it is known
};

/// A chart of what came out.
struct StudyChart {
    std::string word;     ///< for the name of its file, where a study has several: "levels"
    Plot plot;            ///< without marks or curves: there is nothing to draw
    Phrase missing = {};  ///< what is said in place of the chart; empty: it is drawn
};

/// The results, ready for output.
struct StudyFindings {
    std::string text = {};             ///< tables to read, in the language of the request
    std::string csv = {};              ///< the table with commas, unless the study refuses it
    std::string json = {};             ///< one object a line
    std::vector<Phrase> remarks = {};  ///< one line each, for who is not quiet
    std::vector<Phrase> problems = {};
    SourceWords undone = "{0} could not be scored:";  ///< of what there are problems with
    std::vector<StudyChart> charts = {};
};

/// An option of evaluate that a study has no use for, and why.
struct Refusal {
    std::string_view option;  ///< "sweep"
    SourceWords why;
};

// The common part of several studies.
inline constexpr Refusal kAsItIs[] = {{"sweep", SourceWords("this study tries each recipe as it is")}};
inline constexpr std::string_view kDots[] = {"none"};                            ///< recipes without lines that could be compared
inline constexpr std::string_view kDotsAndRegions[] = {"none", "kmeans"};        ///< recipes without lines that could be mended
inline constexpr std::string_view kRandomStart = "kmeans k=4 method=iterative";  ///< beside the exact one

struct Study {
    std::string_view name = {};             ///< "matching"; empty: what evaluate does without --study
    std::string_view details = {};          ///< what it measures and what its columns mean; continues from its name, "measures
                                            ///< how much ..."
    bool needs_maps = true;                 ///< false: pictures without contour maps are enough
    std::span<const Option> options = {};   ///< whole numbers that it alone asks for; their summaries go on with the default
    SourceWords no_options = "";            ///< why the others have no use for them
    std::span<const Refusal> refuses = {};  ///< in the order in which they are told
    std::string_view paper = {};            ///< of its sheets, which have no margin; empty: as convert makes a page
    std::span<const std::string_view> recipes = {};  ///< default recipes; empty: all, and auto
    std::span<const std::string_view> without = {};  ///< of all recipes those that it can tell nothing of
    std::string_view besides = {};                   ///< a step that is a recipe of its own beside them
    /// The named items of its chart; nullptr: no chart.
    std::vector<std::string> (*charted)(std::span<const Candidate> candidates) = nullptr;
    /// The same with any number of workers, but for times and memory. Throws Error if the whole cannot be done.
    StudyFindings (*run)(const StudyRequest& request, const StudyWatch& watch) = nullptr;
};

}  // namespace tactics
