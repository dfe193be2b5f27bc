// SPDX-License-Identifier: Apache-2.0
// The help as plain text that reads well from top to bottom: short lines, no columns, no drawing characters.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

std::string describe_program();

/// Help for everything of that name in any list (sobel is a filter and a recipe). Throws Error(usage) with the nearest name.
std::string describe_topic(std::string_view name);

}  // namespace tactics
