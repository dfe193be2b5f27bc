// SPDX-License-Identifier: Apache-2.0
// `evaluate --study repair`: what mending a drawing for the rules costs, and what is left.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "studies/study.h"
#include "tactics/measure/score.h"
#include "tactics/plot.h"

namespace tactics {

/// One picture by one recipe.
struct RepairTrial {
    bool tried = false;
    Counts before, after;  ///< of the drawing's lines against those that people drew; nothing without contour maps
    std::size_t hard_before = 0, hard_after = 0;  ///< places that break a hard rule
    double kept = 1;                              ///< share of the drawn line
    bool legible = true;                          ///< else the user is told to split it, to enlarge it or to describe it instead
    double repair_ms = 0;                         ///< CPU time
    double page_ms = 0;                           ///< from the file of the picture to that of the page, as PDF
};

struct RepairRecipe {
    std::string name;
    std::vector<RepairTrial> trials;  ///< by picture
};

struct RepairStudy {
    std::vector<std::string> pictures;
    std::vector<RepairRecipe> recipes;
    std::vector<Phrase> problems;
};

std::string repair_text(const RepairStudy& study, std::string_view language);
/// One object a line: each recipe with its pictures, and last what the whole was.
std::string repair_json(const RepairStudy& study);
/// Places that break a hard rule against the share of people's contours that is drawn: a mark for each recipe after repair, and
/// a line to it from where it was before.
Plot repair_plot(const RepairStudy& study);

}  // namespace tactics
