// SPDX-License-Identifier: Apache-2.0
#include "cli/chain.h"

#include "cli/kept_recipes.h"
#include "filters/list.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// With those that are kept among the nearest names.
[[noreturn]] void refuse_unknown(const std::string& name, const std::vector<KeptRecipe>& kept) {
    std::vector<std::string_view> names;
    for (const KeptRecipe& recipe : kept) names.push_back(recipe.name);
    const std::string near = did_you_mean(name, names);
    if (near.empty()) find_recipe(name, "--recipe");
    throw Error(Fault::usage, "--recipe",
                phrase("there is no recipe \"{0}\"{1}; see tactics list recipes, or name a recipe file", name, near));
}

Recipe read_recipe(const std::string& name, RecipeWish& chain, const Disk& disk, bool with_kept) {
    bool known = false;
    for (const NamedRecipe& recipe : named_recipes()) known = known || recipe.name == name;
    if (known) return find_recipe(name, "--recipe");
    const bool path = name.find('/') != std::string::npos || name.ends_with(".recipe");
    std::string file = name;
    if (!path && (!disk.exists(name) || disk.is_folder(name))) {
        file = with_kept ? kept_recipe_file(name) : "";
        if (file.empty() && !disk.exists(name)) refuse_unknown(name, with_kept ? kept_recipes() : std::vector<KeptRecipe>{});
        if (file.empty()) file = name;
    }
    if (disk.is_folder(file))
        throw Error(Fault::usage, "--recipe",
                    phrase("{0} is a folder; name a recipe file in it, or a recipe of tactics list recipes", name));
    chain.file = file;
    Recipe recipe = parse_recipe(disk.read_text(file), file, filters());
    recipe.name = name;
    return recipe;
}

}  // namespace

RecipeWish read_chain(const Given& given, const Disk& disk) {
    RecipeWish chain;
    std::vector<Step> steps;
    const auto& filter_words = given.all("--filter");
    for (std::size_t i = 0; i < filter_words.size(); ++i) {
        if (i == kMaxRecipeSteps) throw Error(Fault::usage, "--filter", phrase("a recipe has at most 100 filters"));
        steps.push_back(parse_step(filter_words[i], "--filter " + std::to_string(i + 1), filters()));
    }
    const auto& sets = given.all("--set");
    for (std::size_t i = 0; i < sets.size(); ++i) {
        Change change = parse_change(sets[i], "--set " + std::to_string(i + 1));
        if (find_filter(filters(), change.name) != nullptr) chain.changes.push_back(std::move(change));
    }
    chain.detail = given.value("--detail");
    chain.as_drawn = chain.detail == "contours";
    if (!chain.detail.empty() && chain.detail != "touch" && chain.detail != "contours" && chain.detail != "best" &&
        !parse_number(chain.detail))
        throw Error(
            Fault::usage, "--detail",
            phrase("it cannot be \"{0}\"{1}; it is touch, best, contours, or a number: so many times the line that touch allows",
                   chain.detail.substr(0, 80), did_you_mean(chain.detail, {"touch", "best", "contours"})));

    if (!given.has("--recipe") && !steps.empty()) {
        chain.base = Recipe{"made of --filter", "", std::move(steps)};
        return chain;
    }
    chain.added = std::move(steps);
    const std::string name = given.value("--recipe", "auto");
    if (name != "auto") chain.base = read_recipe(name, chain, disk, !given.has("--no-defaults"));
    if (name == "auto") check_detail(chain.detail);
    return chain;
}

}  // namespace tactics
