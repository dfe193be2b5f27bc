// SPDX-License-Identifier: Apache-2.0
#include "cli/page_choices.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/kept_choices.h"

namespace tactics {

namespace {

// Destinations, formats (each page's record has its own), reporting, and options that only refuse pages.
constexpr std::string_view kSamePages[] = {"--output",   "--to",      "--files-from", "--null",    "--labels", "--save-recipe",
                                           "--allow",    "--jobs",    "--update",     "--no-sync", "--strict", "--quiet",
                                           "--warnings", "--verbose", "--progress",   "--json",    "--help",   "--no-defaults"};
constexpr std::string_view kSamePagesKept[] = {"progress", "machine"};

// A value that names a file counts by what is in it.
std::string with_mark(std::string value) {
    std::error_code fault;
    if (!std::filesystem::is_regular_file(value, fault)) return value;
    const std::string mark = mark_of_file(value);
    return mark == "missing" ? value : value + " (" + mark + ")";
}

}  // namespace

bool changes_pages(std::string_view flag) {
    return std::find(std::begin(kSamePages), std::end(kSamePages), flag) == std::end(kSamePages);
}

MadeWith page_choices(const Command& command, const Given& given, const RecipeWish& recipe) {
    MadeWith with{{"version", TACTICS_VERSION}};
    for (const Flag& flag : command.flags) {
        if (!changes_pages(flag.name)) continue;
        const std::vector<std::string>& values = given.all(flag.name);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const bool kept_recipe = flag.name == "--recipe" && !recipe.file.empty();
            with.emplace_back(std::string(flag.name) + (i == 0 ? "" : " (" + std::to_string(i + 1) + ")"),
                              kept_recipe ? values[i] + " (" + mark_of_file(recipe.file) + ")" : with_mark(values[i]));
        }
    }
    for (const KeptWord& word : kept_words()) {
        const KeptValue* kept = given.kept(word.name);
        const bool same = std::find(std::begin(kSamePagesKept), std::end(kSamePagesKept), word.name) != std::end(kSamePagesKept);
        if (kept != nullptr && !same) with.emplace_back("the kept " + std::string(word.name), with_mark(kept->value));
    }
    return with;
}

}  // namespace tactics
