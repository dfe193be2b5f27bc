// SPDX-License-Identifier: Apache-2.0
// Patterns of SVG, told apart by what they paint: poppler and cairo write one for each surface, alike but for its name.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "tactics/readers/xml.h"

namespace tactics {

/// From 1 to 2, the same for the same text.
double pattern_number(std::string_view text);

/// Of each pattern in a drawing, by its id: the same number for the same content, wherever that is kept.
std::map<std::string, double, std::less<>> pattern_numbers(const Element& root);

}  // namespace tactics
