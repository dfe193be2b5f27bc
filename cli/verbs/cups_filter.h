// SPDX-License-Identifier: Apache-2.0
// The program as a filter of CUPS: called as tacticstoembosser it makes the bytes of an embosser of a print job.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// The name that the program is called by, as CUPS's PPD files name their filters.
inline constexpr std::string_view kCupsFilterName = "tacticstoembosser";

/// The program was started under that name. (Its first word tells nothing: CUPS puts the name of the queue there.)
bool is_called_by_cups();

/// `words` are what CUPS gives a filter (filter(7)): job, user, title, copies, options and, if there is one, the file; else the
/// job is on standard input. The PPD file that the variable PPD names says which embosser it is for. Bytes go to standard output,
/// messages to standard error as CUPS reads them. Gives the exit code.
int run_cups_filter(std::span<const std::string> words);

/// NAME=VALUE of options as CUPS writes them, `a=b flag nofold c='d e'`, in their order; a name alone is true, with "no" before
/// it false.
std::vector<std::pair<std::string, std::string>> parse_cups_options(std::string_view text);

}  // namespace tactics
