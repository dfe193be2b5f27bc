// SPDX-License-Identifier: Apache-2.0
#include "filters/list.h"

#include <string>

#include "tactics/error.h"

namespace tactics {

#define FILTER(name) extern const Filter name##_filter;
#include "filters/list.inc"
#undef FILTER

FilterList filters() {
    static const Filter* const kFilters[] = {
#define FILTER(name) &name##_filter,
#include "filters/list.inc"
#undef FILTER
    };
    return kFilters;
}

Recipe find_recipe(std::string_view name, std::string_view place) {
    std::vector<std::string_view> names;
    for (const auto& recipe : named_recipes()) {
        if (recipe.name == name) {
            Recipe found = parse_recipe(recipe.text, recipe.name, filters());
            found.summary = std::string(recipe.summary);
            found.has_words = recipe.has_words;
            return found;
        }
        names.push_back(recipe.name);
    }
    throw Error(Fault::usage, place,
                phrase("there is no recipe \"{0}\"{1}; see tactics list recipes, or name a recipe file", name,
                       did_you_mean(name, names)));
}

}  // namespace tactics
