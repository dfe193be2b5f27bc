// SPDX-License-Identifier: Apache-2.0
// Output of the program: lines for the user on standard error, results on standard output.
#pragma once

#include <string>
#include <string_view>

#include "tactics/text/phrase.h"

namespace tactics {

/// File names may hold anything; bytes that control a terminal (tactics/text/utf8.h) are shown as \x0a, byte for byte, so that a
/// line stays one line.
std::string one_line(std::string_view text);

/// One whole line on standard error, in the language of the user (user_language.h).
void say(const Phrase& line);

/// Writes to standard output. Throws Error(failed) if that fails; a closed pipe is no error.
void print_out(std::string_view text);

}  // namespace tactics
