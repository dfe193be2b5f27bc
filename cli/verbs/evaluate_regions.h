// SPDX-License-Identifier: Apache-2.0
// `evaluate --study regions`: the regions of a picture against those of people.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/verbs/evaluate_request.h"
#include "tactics/image.h"
#include "tactics/measure/regions.h"
#include "tactics/recipe.h"
#include "tactics/text/table.h"

namespace tactics {

/// The regions that a recipe finds, on a map of that size, one for each of region_levels(); neighbours that are alike are the
/// same object. They are the parts that its lines enclose, of all lines as strong as the level, and of a picture the parts of one
/// value. Dots are left out of the recipe.
std::vector<std::shared_ptr<const LabelMap>> regions_of_recipe(Recipe recipe, Image image, int width, int height);

/// The regions of each annotator.
std::vector<LabelMap> regions_of_people(const std::vector<PixelSet>& truths);

struct RegionRow {
    std::string name;
    bool has_levels = false;          ///< else it is a person, whose regions are what they are
    std::vector<RegionTrial> trials;  ///< by picture; those without a curve could not be scored
};

struct RegionStudy {
    std::vector<std::string> pictures;
    std::vector<RegionRow> rows;  ///< the recipes, people, and the simplest person
    std::vector<std::string> problems;
};

std::vector<Row> region_rows(const RegionStudy& study);
/// One object a line: each row with its pictures, and last what the whole was.
std::string region_json(const RegionStudy& study);

/// The whole study as asked for; gives the exit code.
int run_region_study(const EvaluateRequest& request);

}  // namespace tactics
