// SPDX-License-Identifier: Apache-2.0
// A chain of filters with their settings, from the command line or a recipe file.
//
// A recipe file is plain text with one filter per line, in the order of application:
//
//     # edges first, then segmentation
//     resample dpi=150
//     sobel blur=0.5mm
//     kmeans k=4 keep=2
//     trace
//
// `#` starts a comment; a comment on the first line is the recipe's summary. Spaces separate; no quoting.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/filter.h"

namespace tactics {

struct Step {
    const Filter* filter = nullptr;
    Settings settings;
    std::string place;  ///< where the user wrote it: "lines.recipe:3", "--filter 2"
};

struct Recipe {
    std::string name;     ///< "photo", "my.recipe"
    std::string summary;  ///< one line, may be empty
    std::vector<Step> steps;
    bool has_words = false;  ///< print in its pictures names things and is read; unknown for recipe files
};

inline constexpr std::size_t kMaxRecipeBytes = 64 * 1024;
inline constexpr std::size_t kMaxRecipeSteps = 100;

/// One line: "sobel blur=0.5mm". Throws Error(usage) at `place`.
Step parse_step(std::string_view line, std::string_view place, FilterList filters);

/// A whole file; `origin` is the file name in error places. Throws Error(usage).
Recipe parse_recipe(std::string_view text, std::string_view origin, FilterList filters);

/// Text that parse_recipe reads back to the same steps.
std::string to_text(const Recipe& recipe);

/// Checks the kinds through the chain, starting from a picture, before any work on pixels; returns the kind at the end. Throws
/// Error(usage) at a step that cannot take its input, and names the filter to put before it.
Kind check(const Recipe& recipe);

bool uses_colour(const Recipe& recipe);

/// Called before each step with its index, for progress and timing.
using StepWatcher = std::function<void(std::size_t)>;

Artwork run(const Recipe& recipe, Artwork artwork, const StepWatcher& watcher = {});

/// The same, but writes the filters' choices into the recipe. Returns their explanations, each after the filter's name.
Artwork run_settling(Recipe& recipe, Artwork artwork, std::vector<ChosenSetting>& said);

}  // namespace tactics
