// SPDX-License-Identifier: Apache-2.0
// What `evaluate` was asked to do: complete and checked before the first picture is opened.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/chain.h"
#include "cli/command.h"
#include "cli/verbs/evaluate_chart.h"
#include "tactics/layout/sheet.h"
#include "tactics/measure/truth.h"
#include "tactics/page.h"

namespace tactics {

/// A recipe to be scored, at each setting of the sweep; at one if the sweep does not concern it.
struct Candidate {
    std::string name;
    std::vector<std::string> settings;  ///< "k=3"; one empty text without a sweep
    std::vector<Recipe> recipes;        ///< by setting; none: chosen for each picture (auto)
    RecipeWish chain;
};

struct EvaluateRequest {
    std::vector<Subject> subjects;
    std::vector<std::string> problems;  ///< of the folders, one line each
    std::vector<Candidate> candidates;
    Sheet sheet;
    std::string study;              ///< as in --study; empty: against contours that people drew
    std::uint64_t seed = 1;         ///< of what is left to chance
    std::vector<ChartFile> charts;  ///< --chart
    std::string csv;                ///< file, or empty
    int workers = 0;                ///< 0: as many as there are cores
    bool quiet = false;
    bool json = false;
};

/// Throws Error(usage); Error(failed) for a folder or a recipe file that cannot be read.
EvaluateRequest plan_evaluation(const Given& given, const Disk& disk);

}  // namespace tactics
