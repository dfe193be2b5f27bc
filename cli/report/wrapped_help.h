// SPDX-License-Identifier: Apache-2.0
// Help on a terminal, wrapped between words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactics {

/// `text` in lines of at most `width` letters, broken only between words, so that the names of options and files stay whole;
/// continuation lines of an entry are indented by four more. Lines to be typed are unchanged: those that begin with "Example:",
/// and those below "Example:" or "Examples:".
std::string wrapped_help(std::string_view text, std::size_t width);

/// Writes to standard output. On a terminal it wraps at COLUMNS if that is set, else at the terminal's width; elsewhere it does
/// not wrap. Throws Error(failed) as print_out does.
void print_help(std::string_view text);

}  // namespace tactics
