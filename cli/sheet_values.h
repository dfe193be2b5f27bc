// SPDX-License-Identifier: Apache-2.0
// Parses the values of sheet options. Each function throws Error(usage) at the place where the value was given.
#pragma once

#include <string>
#include <string_view>

#include "cli/command.h"
#include "tactics/layout/sheet.h"

namespace tactics {

/// "left=15mm"
Binding binding_of(const std::string& text, std::string_view place);
/// A BCP 47 language tag, as written; it is not checked that the language exists.
std::string language_of(const std::string& text, std::string_view place);
/// "15mm", in mm
double margin_of(const std::string& text, std::string_view place);

/// --tiles: "2x2"
Tiles tiles_value(const Given& given);
/// --scale: "1:100" or "1cm=1m", as mm on the page per mm in the world
double scale_value(const Given& given);

}  // namespace tactics
