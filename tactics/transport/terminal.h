// SPDX-License-Identifier: Apache-2.0
// Bytes that a terminal would obey rather than show.
#pragma once

#include <string_view>

namespace tactics {

/// Whether it has ASCII control characters other than tabs, line ends and form feeds, as in a PDF, a picture or a machine's
/// commands. BRF, SVG and other text has none, in any encoding.
bool is_binary(std::string_view bytes);

/// Throws Error(usage), with the cure, if they are binary and standard output is a terminal.
void check_terminal(std::string_view bytes);

}  // namespace tactics
