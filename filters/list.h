// SPDX-License-Identifier: Apache-2.0
// All filters, in the order of the help. To add one: a file that defines `extern const Filter NAME_filter`, one line in list.inc.
#pragma once

#include "tactics/filter.h"
#include "tactics/recipe.h"

namespace tactics {

FilterList filters();

/// A recipe that comes with the program, as text that a recipe file could hold.
struct NamedRecipe {
    std::string_view name;
    std::string_view summary;
    std::string_view text;
    bool has_words = false;  ///< what it is for has its words beside its things; in a photograph print is a part of a thing
};
std::span<const NamedRecipe> named_recipes();
Recipe find_recipe(std::string_view name, std::string_view place);  ///< throws Error(usage) with the nearest name

}  // namespace tactics
