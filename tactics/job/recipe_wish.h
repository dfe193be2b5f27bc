// SPDX-License-Identifier: Apache-2.0
// The user's wishes about how a picture becomes a drawing.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/recipe.h"

namespace tactics {

/// `--set NAME.OPTION=VALUE`
struct Change {
    std::string name;
    std::string option;
    std::string value;
    std::string place;  ///< "--set 2"
};

/// Throws Error(usage) if the text has another form, or if neither a filter nor a format has that name.
Change parse_change(std::string_view text, std::string_view place);

struct RecipeWish {
    std::optional<Recipe> base;   ///< nothing: to be chosen for each picture (auto)
    std::vector<Step> added;      ///< --filter together with --recipe: appended
    std::vector<Change> changes;  ///< only those of filters
    std::string detail;           ///< --detail, or empty
    bool as_drawn = false;        ///< the drawing is not mended for the rules: --as-drawn, or all contours are requested
    std::string file;             ///< the recipe file that was read, or empty
};

/// Throws Error(usage) for a number that no recipe for photographs allows; a picture's recipe is only chosen when it is read.
void check_detail(const std::string& detail);

/// Whether it has a line budget, which `detail` changes.
bool keeps_some(const Recipe& recipe);

/// Whether it has any wish about drawing, which a file of lines does not need.
bool asks_for_a_way(const RecipeWish& wish);

/// `base` with all wishes applied, preceded by `resample` if no step is one, and checked from the first filter to the last.
/// Throws Error(usage).
Recipe assemble(const RecipeWish& chain, Recipe base);

/// The same, made printable: followed by `threshold` if it ends in an uncut edge map, or by `outlines` if it ends in regions.
Recipe finish(const RecipeWish& chain, Recipe base);

}  // namespace tactics
