// SPDX-License-Identifier: Apache-2.0
// Recipe files that a person or a machine keeps: NAME.recipe in the folder `recipes` of those of config_folders.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactics {

struct KeptRecipe {
    std::string name;  ///< "lines"
    std::string file;  ///< "~/.config/tactics/recipes/lines.recipe"
};

/// By name; of files of one name the most important. Those with the name of a recipe that comes with the program are left out:
/// that name means the same everywhere.
std::vector<KeptRecipe> kept_recipes();

/// The file of that recipe; empty: none is kept by that name.
std::string kept_recipe_file(std::string_view name);

}  // namespace tactics
