// SPDX-License-Identifier: Apache-2.0
// Names of pictures from a file, for more names than a command line can hold.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"

namespace tactics {

/// The names in a list, one per line or, with `null`, each followed by a zero byte, as find -print0 writes them. Empty names and
/// a carriage return at the end of a line are dropped.
std::vector<std::string> names_in(std::string_view list, bool null);

/// The words of the command line, then the names from --files-from. Throws Error(usage) for --null alone, an empty list, or
/// standard input as both the list and a picture; Error(failed) if the list cannot be read or has over 64 MB.
std::vector<std::string> named_files(const Given& given);

}  // namespace tactics
