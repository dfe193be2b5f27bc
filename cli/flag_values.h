// SPDX-License-Identifier: Apache-2.0
// Values of options that many commands share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/report/progress.h"

namespace tactics {

/// How much is reported about pictures on standard error. usual: everything about one picture; for each of many, one line and
/// everything that a person must act on. Failures are always reported.
enum class Loudness { errors, warnings, usual, all };

/// --page, or 0. Throws Error(usage).
int page_value(const Given& given);
/// The same for --page 1-3,7: the pages in order, at most 10,000; only 0 if none is named.
std::vector<int> pages_value(const Given& given);
/// --allow: of kAskedFormats. Throws Error(usage).
std::vector<std::string> allowed_formats(const Given& given);
/// --quiet, --warnings or --verbose. Throws Error(usage) for more than one of them.
Loudness loudness_value(const Given& given);
/// "none", "lines" or "bar". Throws Error(usage) at `place`.
ProgressWay progress_of(const std::string& text, std::string_view place);
/// --progress, or the kept choice. Throws Error(usage).
ProgressWay progress_value(const Given& given);
/// --jobs, or 0. Throws Error(usage).
int workers_value(const Given& given);
/// A number of an option, or `fallback` if it was not given. Throws Error(usage).
double number_value(const Given& given, std::string_view name, double fallback, double least, double most, bool whole = false);
/// A length of an option, in mm. Throws Error(usage).
double length_value(const Given& given, std::string_view name, double least);

}  // namespace tactics
