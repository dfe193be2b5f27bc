// SPDX-License-Identifier: Apache-2.0
// A picture of an evaluation with what people drew of it, and recipes on it: what the studies do alike.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cli/verbs/evaluate_request.h"
#include "tactics/image.h"
#include "tactics/page.h"
#include "tactics/readers/read.h"
#include "tactics/recipe.h"
#include "tactics/text/table.h"

namespace tactics {

struct MappedPicture {
    PictureInfo info;
    std::vector<PixelSet> truths;  ///< what each annotator drew
};

/// Throws Error: unreadable, or no map although it needs one.
MappedPicture read_mapped(const Subject& subject, bool needs_map);

/// A recipe, chosen and fitted to the medium, with the picture as it wants to see it.
struct ReadyRecipe {
    Recipe recipe;
    Image image;
    Rect place;  ///< of the drawing on the sheet
};

/// Throws Error: unreadable, or the recipe draws only a part of the picture.
ReadyRecipe make_ready(const EvaluateRequest& request, const Subject& subject, const Candidate& candidate,
                       std::size_t setting = 0);

/// Dots stand for greys; what they fill has regions and borders. Throws Error if the recipe does nothing but that.
Recipe without_dots(Recipe recipe);

/// Tries a recipe, by its number in the request.
using TryRecipe = std::function<void(std::size_t candidate)>;
/// Takes a picture, by its number in the request, and gives what tries recipes on it.
using OpenPicture = std::function<TryRecipe(std::size_t picture, const MappedPicture& mapped)>;

/// Every recipe on every picture, all cores at work. What goes wrong is told at once, and given as lines, those of the folders
/// first.
std::vector<std::string> try_all(const EvaluateRequest& request, bool needs_maps, const OpenPicture& open);

/// To standard output as a table, as JSON or with commas, and to the file of --csv, as asked for.
void give_out(const EvaluateRequest& request, const std::vector<Row>& rows, const std::string& json);

}  // namespace tactics
