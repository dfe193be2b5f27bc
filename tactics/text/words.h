// SPDX-License-Identifier: Apache-2.0
// The words of a line: of recipes, and of the lists of names in the descriptions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// Separators of words. They include the carriage return, because recipes are written on any system.
inline constexpr std::string_view kBlanks = " \t\r";

/// The words point into `line`, which must outlive them.
std::vector<std::string_view> words_of(std::string_view line);

/// Without the blanks at both ends.
std::string_view trimmed(std::string_view line);

/// Joined with `last` before the last one: "a, b and c" for ", " and " and ".
std::string joined(const std::vector<std::string_view>& words, std::string_view between, std::string_view last);

}  // namespace tactics
