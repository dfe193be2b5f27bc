// SPDX-License-Identifier: Apache-2.0
#include "cli/page_choices.h"

#include <algorithm>

#include "cli/kept_choices.h"

namespace tactics {

namespace {

// Where pages go, which formats they have (each page's record has its own), how it is told, and what only refuses.
constexpr std::string_view kSamePages[] = {"--output",   "--to",      "--files-from", "--null",    "--labels", "--save-recipe",
                                           "--allow",    "--jobs",    "--update",     "--no-sync", "--strict", "--quiet",
                                           "--warnings", "--verbose", "--progress",   "--json",    "--help",   "--no-defaults"};
constexpr std::string_view kSamePagesKept[] = {"progress", "machine"};

std::string with_mark(std::string value) {
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
        std::string all;
        for (std::string value : given.all(flag.name)) {
            if (flag.name == "--recipe" && !recipe.file.empty()) value += " (" + mark_of_file(recipe.file) + ")";
            if (flag.name == "--braille" && value.find('/') != std::string::npos) value = with_mark(std::move(value));
            all += (all.empty() ? "" : ", ") + value;
        }
        if (given.has(flag.name)) with.emplace_back(flag.name, all);
    }
    for (const KeptWord& word : kept_words()) {
        const KeptValue* kept = given.kept(word.name);
        const bool same = std::find(std::begin(kSamePagesKept), std::end(kSamePagesKept), word.name) != std::end(kSamePagesKept);
        if (kept != nullptr && !same)
            with.emplace_back("the kept " + std::string(word.name),
                              kept->value.starts_with('/') ? with_mark(kept->value) : kept->value);
    }
    return with;
}

}  // namespace tactics
