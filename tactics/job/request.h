// SPDX-License-Identifier: Apache-2.0
// What is asked for: complete and checked before the first picture is opened.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tactics/job/job.h"
#include "tactics/job/print_words.h"
#include "tactics/job/recipe_wish.h"
#include "tactics/layout/sheet.h"

namespace tactics {

struct Outcome;

struct Request {
    std::vector<Job> jobs;
    RecipeWish chain;
    std::optional<Recipe> recipe;  ///< finished; nothing: it is chosen for each picture
    Sheet sheet;                   ///< all but paper and medium, which may come from the format
    std::optional<Paper> paper;
    int page = 0;  ///< of a PDF; 0: its first
    int zoom = 1;  ///< of what a display shows
    bool title_from_name = false;
    std::vector<std::pair<const Format*, Settings>> settings;  ///< of each format that is written
    bool fixed_dpi = false;                  ///< --dpi or --set said how many dots there are, so --bare leaves that alone
    WordsWish words = WordsWish::automatic;  ///< what becomes of print in pictures
    std::string save_recipe;
    std::set<std::string> taken;  ///< taken_by, which is filled in when the folders are there
    int workers = 0;              ///< 0: as many as there are cores
    bool update = false;
    bool quiet = false;
    /// What is told of each picture on standard output, with its line end; nullptr: nothing.
    std::string (*answer)(const Outcome& outcome) = nullptr;

    const Settings& settings_of(const Format& format) const;
};

/// The recipe that is the same for all pictures, with what matters in them if that is the same, too.
Recipe saved_recipe(const Request& request);

/// The sheet that a format is laid out on. Two sheets of one request differ in paper, medium and machine
/// only.
Sheet sheet_for(const Request& request, const Format& format, const Job& job);
bool same_sheet(const Sheet& a, const Sheet& b);

}  // namespace tactics
