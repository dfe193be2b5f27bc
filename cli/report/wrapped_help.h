// SPDX-License-Identifier: Apache-2.0
// Help on a terminal: lines that are broken between words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactics {

/// `text` with lines of at most `width` letters, each broken between words and never within one, so that the name of an option or
/// a file stays whole; what goes on of a line that tells of one thing is set in by four more. Lines to be typed stay as they are:
/// those that begin with "Example:", and those below "Example:" or "Examples:".
std::string wrapped_help(std::string_view text, std::size_t width);

/// Standard output: wrapped where it is a terminal, to COLUMNS if that is set, else to what the terminal says; elsewhere as it
/// is. Throws Error(failed) as print_out does.
void print_help(std::string_view text);

}  // namespace tactics
