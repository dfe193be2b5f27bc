// SPDX-License-Identifier: Apache-2.0
// Bytes that a terminal would obey rather than show.
#pragma once

#include <string_view>

namespace tactics {

/// Holds control characters of ASCII other than tabs, ends of lines and of pages: a PDF, a picture, a machine's commands. Braille
/// in letters (BRF), SVG and other text has none, in whatever coding its letters are.
bool is_binary(std::string_view bytes);

/// Throws Error(usage), with the cure, if they are binary and standard output is a terminal.
void check_terminal(std::string_view bytes);

}  // namespace tactics
