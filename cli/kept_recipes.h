// SPDX-License-Identifier: Apache-2.0
// Recipe files kept by a user or on a machine: NAME.recipe in the subfolder `recipes` of the folders of config_folders.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactics {

struct KeptRecipe {
    std::string name;  ///< "lines"
    std::string file;  ///< "~/.config/tactics/recipes/lines.recipe"
};

/// Sorted by name; of files with the same name, only the most important. Names of recipes that come with the program are left
/// out, because such a name must mean the same everywhere.
std::vector<KeptRecipe> kept_recipes();

/// The file of that recipe; empty: no such recipe is kept.
std::string kept_recipe_file(std::string_view name);

}  // namespace tactics
