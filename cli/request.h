// SPDX-License-Identifier: Apache-2.0
// What `convert` was asked to do, from its options.
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

/// Exit code of --strict: what was asked for is done, and a hard rule is broken.
inline constexpr int kRuleBroken = 3;

/// What a command is to do: complete and checked before the first picture is opened.
struct Request : Wishes {
    std::vector<Item> items;
    std::vector<Phrase> notes = {};  ///< of the plan, for the user: what drives a machine that was named by its model
    int workers = 0;                 ///< 0: as many as there are cores
    bool update = false;
    /// Of what may make other pages, what was asked for and what is kept; nothing: no records are kept of what is made.
    std::optional<MadeWith> made_with = {};
    Loudness loudness = Loudness::usual;
    ProgressWay progress = ProgressWay::automatic;
    /// What is told of each picture on standard output, with its line end; nullptr: nothing.
    std::string (*answer)(const Outcome& outcome) = nullptr;
};

/// The recipe that is the same for all pictures, with what matters in them if that is the same, too.
Recipe saved_recipe(const Request& request);

/// Throws Error(usage), or Error(failed) for a recipe file that cannot be read.
Request plan(const Given& given, const Disk& disk);

/// For a command that knows the page's options but writes no pages: nothing of the rest is asked for.
Request plan_pages(std::vector<Item> items, const Given& given, const Disk& disk);

/// What --output names; one that ends in .prn and names no machine is for the machine that is kept.
std::vector<std::string> named_outputs(const Given& given);

/// For a command that draws charts: a page's own options, and nothing of how a picture becomes a drawing.
Request plan_charts(std::vector<Item> items, const Given& given);

}  // namespace tactics
