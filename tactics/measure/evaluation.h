// SPDX-License-Identifier: Apache-2.0
// The results of an evaluation: every row, as values, from which tables, JSON and charts are made.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tactics/measure/score.h"
#include "tactics/measure/touch.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// One picture by one recipe at one setting.
struct Trial {
    std::vector<Counts> curve;       ///< at each of levels(); empty: it could not be scored, and `error` says why
    std::optional<TouchLoad> touch;  ///< only of drawings
    double recipe_ms = 0;            ///< CPU time of the filters
    double whole_ms = 0;             ///< the same with choosing and reading
    std::string error;

    bool scored() const { return error.empty(); }
    bool nothing() const;  ///< no line at all
};

struct RecipeResult {
    std::string recipe;
    std::vector<std::string> settings;  ///< values of --sweep; one empty text without
    /// By picture (as in Evaluation::pictures), then by setting.
    std::vector<std::vector<Trial>> trials;
};

struct Evaluation {
    std::vector<std::string> pictures;  ///< names, all that were tried
    std::vector<std::size_t> annotators;
    std::vector<Counts> people;    ///< of each picture, one annotator against the others
    std::vector<Counts> simplest;  ///< the same of the one whose map has the fewest regions
    std::vector<RecipeResult> recipes;
    std::vector<Phrase> problems;  ///< all that could not be scored, a line each
    double peak_memory_mib = 0;    ///< of the whole run
};

/// A point of a recipe's dial.
struct Dial {
    std::size_t setting = 0;
    std::size_t level = 0;
};

/// A row of the table: one recipe over all pictures that were scored at every setting.
struct Figures {
    std::size_t scored = 0;
    std::size_t failed = 0;
    std::size_t nothing = 0;  ///< scored pictures on which nothing was drawn, at the best setting
    Counts best;              ///< ODS: one dial for all pictures
    Dial dial;
    bool swept = false;      ///< the level changes something
    Counts best_each;        ///< OIS: the best dial of each picture
    bool has_touch = false;  ///< at the best setting there are drawings
    double length = 0;       ///< mm of stroke a picture
    double strokes = 0;      ///< a picture
    double crowded = 0;      ///< share of the stroke
    double recipe_ms = 0;    ///< median over pictures
    double whole_ms = 0;
};
Figures figures_of(const RecipeResult& result);

/// The dial of that picture's greatest F.
Dial best_of(const std::vector<Trial>& settings);

Counts sum_of(const std::vector<Counts>& counts);

/// The middle value, of an even number the mean of the middle two; 0 of none.
double median_of(std::vector<double> values);

}  // namespace tactics
