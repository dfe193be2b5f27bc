// SPDX-License-Identifier: Apache-2.0
// Options whose value is one of a few words.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "cli/command.h"

namespace tactics {

/// The index of the given word; nothing: the option was not given. Throws Error(usage).
std::optional<std::size_t> choice_value(const Given& given, std::string_view name, const std::vector<std::string_view>& words);

}  // namespace tactics
