// SPDX-License-Identifier: Apache-2.0
// Names of pictures out of a file, for more of them than a command line bears.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"

namespace tactics {

/// The names that a list holds, one a line or, if `null`, each with a zero byte behind it, as find -print0 writes them. Empty
/// ones are left out, and so is a carriage return at the end of a line.
std::vector<std::string> names_in(std::string_view list, bool null);

/// The words, and what --files-from names besides, in that order. Throws Error(usage): --null alone; the list names nothing;
/// standard input is to be the list and a picture; Error(failed): the list cannot be read, or has over 64 MB.
std::vector<std::string> named_files(const Given& given);

}  // namespace tactics
