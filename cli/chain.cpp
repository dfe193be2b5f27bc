// SPDX-License-Identifier: Apache-2.0
#include "cli/chain.h"

#include "filters/list.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

Recipe read_recipe(const std::string& name, RecipeWish& chain, const Disk& disk) {
    bool known = false;
    for (const NamedRecipe& recipe : named_recipes()) known = known || recipe.name == name;
    const bool file = name.find('/') != std::string::npos || name.ends_with(".recipe") || (!known && disk.exists(name));
    if (!file) return find_recipe(name, "--recipe");
    if (disk.is_folder(name))
        throw Error(Fault::usage, "--recipe",
                    name + " is a folder; name a recipe file in it, or a recipe of tactics list recipes");
    chain.file = name;
    Recipe recipe = parse_recipe(disk.read_text(name), name, filters());
    recipe.name = name;
    return recipe;
}

}  // namespace

RecipeWish read_chain(const Given& given, const Disk& disk) {
    RecipeWish chain;
    std::vector<Step> steps;
    const auto& filter_words = given.all("--filter");
    for (std::size_t i = 0; i < filter_words.size(); ++i) {
        if (i == kMaxRecipeSteps) throw Error(Fault::usage, "--filter", "a recipe has at most 100 filters");
        steps.push_back(parse_step(filter_words[i], "--filter " + std::to_string(i + 1), filters()));
    }
    const auto& sets = given.all("--set");
    for (std::size_t i = 0; i < sets.size(); ++i) {
        Change change = parse_change(sets[i], "--set " + std::to_string(i + 1));
        if (find_filter(filters(), change.name) != nullptr) chain.changes.push_back(std::move(change));
    }
    chain.detail = given.value("--detail");
    chain.as_drawn = chain.detail == "contours";
    if (!chain.detail.empty() && chain.detail != "touch" && chain.detail != "contours" && !parse_number(chain.detail))
        throw Error(Fault::usage, "--detail",
                    "it cannot be \"" + chain.detail.substr(0, 80) + "\"" + did_you_mean(chain.detail, {"touch", "contours"}) +
                        "; it is touch, contours, or a number: so many times the line that touch allows");

    if (!given.has("--recipe") && !steps.empty()) {
        chain.base = Recipe{"made of --filter", "", std::move(steps)};
        return chain;
    }
    chain.added = std::move(steps);
    const std::string name = given.value("--recipe", "auto");
    if (name != "auto") chain.base = read_recipe(name, chain, disk);
    if (name == "auto") check_detail(chain.detail);
    return chain;
}

}  // namespace tactics
