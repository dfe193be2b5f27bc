// SPDX-License-Identifier: Apache-2.0
// How a picture becomes a drawing, as far as the person who asks for it says.
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

/// Throws Error(usage) if it is not spelled so, or if neither a filter nor a format has that name.
Change parse_change(std::string_view text, std::string_view place);

struct RecipeWish {
    std::optional<Recipe> base;   ///< nothing: to be chosen for each picture (auto)
    std::vector<Step> added;      ///< --filter together with --recipe: put at the end
    std::vector<Change> changes;  ///< only those of filters
    std::string detail;           ///< --detail, or empty
    bool as_drawn = false;        ///< the drawing is not mended for the rules: --as-drawn, or all contours were asked for
    std::string file;             ///< the recipe file that was read, or empty
};

/// Throws Error(usage) for a number that no photograph's recipe allows; the recipe of a picture is chosen when it is read.
void check_detail(const std::string& detail);

/// It has a budget of line, which `detail` turns.
bool keeps_some(const Recipe& recipe);

/// It says something about how a picture becomes a drawing, which a file of lines is already.
bool asks_for_a_way(const RecipeWish& wish);

/// `base` with everything that the chain asks for, `resample` in front if no step is it, and checked from the first filter
/// to the last. Throws Error(usage).
Recipe assemble(const RecipeWish& chain, Recipe base);

/// The same, with `threshold` behind if it ends in an edge map that nothing has cut, and `outlines` if it ends in regions: what
/// can be printed.
Recipe finish(const RecipeWish& chain, Recipe base);

}  // namespace tactics
