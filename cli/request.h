// SPDX-License-Identifier: Apache-2.0
// What `convert` was asked to do, from its options.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/report/progress.h"
#include "tactics/job/disk.h"
#include "tactics/job/wishes.h"

namespace tactics {

struct Outcome;

/// How much is told of the pictures on standard error. usual: all of one picture; of each of many a line, and what a person must
/// act on. Failures are told in any case.
enum class Loudness { errors, warnings, usual, all };

/// Exit code of --strict: what was asked for is done, and a hard rule is broken.
inline constexpr int kRuleBroken = 3;

/// What a command is to do: complete and checked before the first picture is opened.
struct Request : Wishes {
    std::vector<Item> items;
    std::vector<std::string> notes = {};  ///< of the plan, for the user: what drives a machine that was named by its model
    int workers = 0;                      ///< 0: as many as there are cores
    bool update = false;
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

/// For a command that draws charts: a page's own options, and nothing of how a picture becomes a drawing.
Request plan_charts(std::vector<Item> items, const Given& given);

/// --page, or 0. Throws Error(usage).
int page_value(const Given& given);
/// The same of --page 1-3,7: the pages in their order, at most 10,000; 0 alone if none is named.
std::vector<int> pages_value(const Given& given);
/// --allow: of kAskedFormats. Throws Error(usage).
std::vector<std::string> allowed_formats(const Given& given);
/// --quiet, --warnings or --verbose. Throws Error(usage): more than one of them.
Loudness loudness_value(const Given& given);
/// --progress. Throws Error(usage).
ProgressWay progress_value(const Given& given);
/// --jobs, or 0. Throws Error(usage).
int workers_value(const Given& given);
/// A number of an option, or `fallback` if it was not given. Throws Error(usage).
double number_value(const Given& given, std::string_view name, double fallback, double least, double most, bool whole = false);
/// A length of an option, in mm. Throws Error(usage).
double length_value(const Given& given, std::string_view name, double least);

}  // namespace tactics
