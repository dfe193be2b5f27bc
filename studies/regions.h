// SPDX-License-Identifier: Apache-2.0
// `evaluate --study regions`: the regions of a picture against those of people.
#pragma once

#include <memory>
#include <vector>

#include "tactics/image.h"
#include "tactics/measure/regions.h"
#include "tactics/recipe.h"

namespace tactics {

/// The regions that a recipe finds, on a map of that size, one for each of region_levels(); neighbours that are alike are the
/// same object. They are the parts that its lines enclose, of all lines as strong as the level, and of a picture the parts of one
/// value. Dots are left out of the recipe.
std::vector<std::shared_ptr<const LabelMap>> regions_of_recipe(Recipe recipe, Artwork from, int width, int height);

/// The regions of each annotator.
std::vector<LabelMap> regions_of_people(const std::vector<PixelSet>& truths);

}  // namespace tactics
