// SPDX-License-Identifier: Apache-2.0
// A picture of an evaluation with people's drawings of it, and recipes applied to it; shared by the studies.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/study.h"
#include "tactics/artwork.h"
#include "tactics/page.h"
#include "tactics/readers/read.h"
#include "tactics/recipe.h"

namespace tactics {

/// The picture's file, of a format that the request allows. Throws Error(failed).
Source open_picture(const StudyRequest& request, const Subject& subject);

/// Its size in pixels; what has none (a figure, a table, a model) is as large as its first contour map, or 1,000 pixels if it has
/// none. Throws Error.
PictureInfo size_of(const StudyRequest& request, const Subject& subject);
/// Throws Error for a picture that is cut off, so that this is found out once and not by every recipe.
void read_through(const StudyRequest& request, const Subject& subject);

struct MappedPicture {
    PictureInfo info;
    std::vector<PixelSet> truths;  ///< the drawing of each annotator
};

/// Throws Error if it is unreadable, or has no map although it needs one.
MappedPicture read_mapped(const StudyRequest& request, const Subject& subject, bool needs_map);

/// A recipe, chosen and fitted to the medium, with its input.
struct ReadyRecipe {
    Recipe recipe;
    Artwork from;  ///< the picture as the recipe needs it; for other sources, their drawing, without steps
    Rect place;    ///< of the drawing on the sheet
};

/// Figures, tables and models are drawn as convert draws them. Throws Error: unreadable, or the recipe draws only a part of the
/// picture.
ReadyRecipe make_ready(const StudyRequest& request, const Subject& subject, const Candidate& candidate, std::size_t setting = 0);

/// Dots stand for greys; what they fill has regions and borders. Throws Error if the recipe does nothing but that.
Recipe without_dots(Recipe recipe);

/// A problem that one recipe has: "recipe sobel: photos/a.jpg: ...".
Phrase of_recipe(const std::string& recipe, const Phrase& problem);

/// Tries a recipe, by its number in the request.
using TryRecipe = std::function<void(std::size_t candidate)>;
/// Takes a picture, by its number in the request, and gives what tries recipes on it.
using OpenPicture = std::function<TryRecipe(std::size_t picture, const MappedPicture& mapped)>;

/// Runs every recipe on every picture, on all cores. Reports errors at once, and returns them as lines, those of the folders
/// first.
std::vector<Phrase> try_all(const StudyRequest& request, const StudyWatch& watch, bool needs_maps, const OpenPicture& open);

/// The last object of a study's JSON, with its line's end.
std::string study_json(std::string_view study, std::size_t pictures, const std::vector<Phrase>& problems);

}  // namespace tactics
