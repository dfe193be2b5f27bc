// SPDX-License-Identifier: Apache-2.0
// The man pages, made from all descriptions: roff with the man macros, the same bytes from the same program (no date).
#pragma once

#include <string>

#include "cli/command.h"

namespace tactics {

/// tactics(1): an overview, and all lists.
std::string manual();

/// tactics-convert(1): a command with its options.
std::string manual_of(const Command& command);

}  // namespace tactics
