// SPDX-License-Identifier: Apache-2.0
// What `convert` was asked to do, from its options.
#pragma once

#include <string_view>
#include <vector>

#include "cli/command.h"
#include "tactics/job/request.h"

namespace tactics {

/// Throws Error(usage), or Error(failed) for a recipe file that cannot be read.
Request plan(const Given& given, const Disk& disk);

/// For a command that knows the page's options but writes no pages: nothing of the rest is asked for.
Request plan_pages(std::vector<Job> jobs, const Given& given, const Disk& disk);

/// --jobs, or 0. Throws Error(usage).
int workers_value(const Given& given);
/// A number of an option, or `fallback` if it was not given. Throws Error(usage).
double number_value(const Given& given, std::string_view name, double fallback, double least, double most, bool whole = false);
/// A length of an option, in mm. Throws Error(usage).
double length_value(const Given& given, std::string_view name, double least);

}  // namespace tactics
