// SPDX-License-Identifier: Apache-2.0
// What the program says: lines for the person on standard error, answers on standard output.
#pragma once

#include <string>
#include <string_view>

#include "tactics/text/phrase.h"

namespace tactics {

/// Names of files may hold anything; what steers a terminal (tactics/text/utf8.h) is shown as \x0a, byte for byte, so that a line
/// stays a line.
std::string one_line(std::string_view text);

/// One whole line on standard error, in the language of the user (user_language.h).
void say(const Phrase& line);

/// Standard output. Throws Error(failed) if it cannot be written; a reader that has gone away is no error.
void print_out(std::string_view text);

}  // namespace tactics
