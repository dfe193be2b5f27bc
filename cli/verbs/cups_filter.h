// SPDX-License-Identifier: Apache-2.0
// The program as a CUPS filter: called as tacticstoembosser, it converts a print job to the bytes of an embosser.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tactics {

/// Whether the program was started by the name kCupsFilterName. (Its first word does not show this: CUPS puts the name of the
/// queue there.)
bool is_started_as(std::string_view name);

/// `words` are the arguments of a CUPS filter (filter(7)): job, user, title, copies, options and, optionally, the file; otherwise
/// the job is on standard input. The PPD file in the variable PPD names the embosser. Bytes go to standard output, messages to
/// standard error in CUPS's format. Returns the exit code. The job is not trusted: root's rights are given up before it is read
/// (transport/lesser_rights.h), the environment is cleared, and its options are limited to those of print_options.h.
int run_cups_filter(std::span<const std::string> words);

}  // namespace tactics
