// SPDX-License-Identifier: Apache-2.0
// The program as a filter of CUPS: called as tacticstoembosser it makes the bytes of an embosser of a print job.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tactics {

/// The program was started by that name, kCupsFilterName. (Its first word tells nothing: CUPS puts the name of the queue there.)
bool is_started_as(std::string_view name);

/// `words` are what CUPS gives a filter (filter(7)): job, user, title, copies, options and, if there is one, the file; else the
/// job is on standard input. The PPD file that the variable PPD names says which embosser it is for. Bytes go to standard output,
/// messages to standard error as CUPS reads them. Gives the exit code.
/// Nothing of the job is trusted: root's rights are given up before it is read (transport/lesser_rights.h), the environment is
/// put away, and its options are those of print_options.h.
int run_cups_filter(std::span<const std::string> words);

}  // namespace tactics
