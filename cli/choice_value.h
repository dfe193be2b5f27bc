// SPDX-License-Identifier: Apache-2.0
// Options that take one of a few words.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "cli/command.h"

namespace tactics {

/// Which of the words an option was given, by its place; nothing: it was not given. Throws Error(usage).
std::optional<std::size_t> choice_value(const Given& given, std::string_view name, const std::vector<std::string_view>& words);

}  // namespace tactics
