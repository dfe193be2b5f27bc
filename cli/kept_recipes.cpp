// SPDX-License-Identifier: Apache-2.0
#include "cli/kept_recipes.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/config_folders.h"
#include "filters/list.h"

namespace tactics {

namespace {

bool is_ours(std::string_view name) {
    const auto recipes = named_recipes();
    return name == "auto" ||
           std::any_of(recipes.begin(), recipes.end(), [&](const NamedRecipe& recipe) { return recipe.name == name; });
}

}  // namespace

std::vector<KeptRecipe> kept_recipes() {
    namespace fs = std::filesystem;
    std::map<std::string, std::string> found;
    for (const std::string& folder : config_folders()) {
        std::error_code fault;
        for (fs::directory_iterator entry(folder + "/recipes", fault), end; !fault && entry != end; entry.increment(fault)) {
            const fs::path& file = entry->path();
            const std::string name = file.stem().string();
            if (file.extension() == ".recipe" && !name.empty() && !is_ours(name) && fs::is_regular_file(file, fault))
                found.emplace(name, file.string());
        }
    }
    std::vector<KeptRecipe> recipes;
    for (const auto& [name, file] : found) recipes.push_back({name, file});
    return recipes;
}

std::string kept_recipe_file(std::string_view name) {
    for (KeptRecipe& recipe : kept_recipes())
        if (recipe.name == name) return std::move(recipe.file);
    return "";
}

}  // namespace tactics
