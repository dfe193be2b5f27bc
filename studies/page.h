// SPDX-License-Identifier: Apache-2.0
// `evaluate --study page`: the page that convert makes, against what people would have drawn, and how whole its lines are.
#pragma once

#include <string>
#include <vector>

#include "studies/study.h"
#include "studies/told_table.h"
#include "tactics/measure/consensus.h"
#include "tactics/measure/whole.h"
#include "tactics/plot.h"

namespace tactics {

/// One picture by one recipe, or by a person.
struct PageTrial {
    bool tried = false;
    bool nobody = false;  ///< not tried, but no failure: there is no other person to compare with
    PageShares shares;
    WholeLines lines;
    double page_ms = 0;               ///< CPU time from the file of the picture to the mended drawing
    std::optional<Trust> trust = {};  ///< as the recipe has it
    bool poor = false;                ///< as the people have it
};

struct PageMaker {
    std::string name;
    bool timed = false;             ///< a recipe; else a person
    std::vector<PageTrial> trials;  ///< by picture
};

struct PageStudy {
    std::vector<std::string> pictures;
    std::vector<PageMaker> makers;  ///< the recipes, and the simplest person
    std::vector<Phrase> problems;
};

/// A maker over its pictures: means, of what is told in parentheses medians.
struct PageFigures {
    std::size_t pages = 0;
    double p3 = 0, p1 = 0, diagonals = 0;
    std::optional<double> r3, main_object;                      ///< of those pages that have them
    double whole = 0;                                           ///< share of a page's line
    double lines = 0, length = 0, loose_ends = 0, page_ms = 0;  ///< (medians)
};
PageFigures page_figures(const PageMaker& maker);

std::vector<ToldRow> page_rows(const PageStudy& study);
/// The predicted and actual scores of pages, grouped by the predicted agreement; the first line of each recipe has the pages
/// reported as needing a look. Headings only if no recipe predicts anything.
std::vector<ToldRow> trust_rows(const PageStudy& study);
/// One object a line: each maker with its pages, and last what the whole was.
std::string page_json(const PageStudy& study);

/// P3 or R3 against the time of a page: a disc for each recipe that none beats in both, joined by a curve; rings for the others;
/// a level line for the simplest person.
Plot page_plot(const PageStudy& study, bool recall);

/// A person's drawing, scaled to that width in mm.
Drawing drawing_of_person(const PixelSet& lines, double width);

}  // namespace tactics
