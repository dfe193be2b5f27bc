// SPDX-License-Identifier: Apache-2.0
// The request of `convert`, from its options.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/flag_values.h"
#include "tactics/job/disk.h"
#include "tactics/job/made_record.h"
#include "tactics/job/wishes.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct Outcome;

/// Exit code of --strict: the work is done, but a hard rule is broken.
inline constexpr int kRuleBroken = 3;

/// A command's request, complete and checked before the first picture is opened.
struct Request : Wishes {
    std::vector<Item> items;
    std::vector<Phrase> notes = {};  ///< on the plan, for the user: the driver of a machine that was named by its model
    int workers = 0;                 ///< 0: the number of cores
    bool update = false;
    bool strict = false;  ///< a page that breaks a hard rule is a failure
    /// The given and kept choices that can change pages; nothing: no records are kept.
    std::optional<MadeWith> made_with = {};
    Loudness loudness = Loudness::usual;
    ProgressWay progress = ProgressWay::automatic;
    /// The text for each picture on standard output, with its line end; nullptr: none.
    std::string (*answer)(const Outcome& outcome) = nullptr;
};

/// The recipe shared by all pictures, with their subject if that is also shared.
Recipe saved_recipe(const Request& request);

/// Throws Error(usage), or Error(failed) for a recipe file that cannot be read.
Request plan(const Given& given, const Disk& disk);

/// For a command that has the page options but writes no pages: uses no other options.
Request plan_pages(std::vector<Item> items, const Given& given, const Disk& disk);

/// The outputs of --output; one that ends in .prn and names no machine is for the kept machine.
std::vector<std::string> named_outputs(const Given& given);

/// For a command that draws charts: only the options of pages, not those of drawing pictures.
Request plan_charts(std::vector<Item> items, const Given& given);

}  // namespace tactics
