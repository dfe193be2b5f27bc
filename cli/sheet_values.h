// SPDX-License-Identifier: Apache-2.0
// What is asked of a sheet, out of the words for it. Each throws Error(usage) at the place where they stand.
#pragma once

#include <string>
#include <string_view>

#include "cli/command.h"
#include "tactics/layout/sheet.h"

namespace tactics {

/// "left=15mm"
Binding binding_of(const std::string& text, std::string_view place);
/// A language tag of BCP 47, as it was written; whether there is such a language is not looked up.
std::string language_of(const std::string& text, std::string_view place);
/// "15mm", in mm
double margin_of(const std::string& text, std::string_view place);

/// --tiles: "2x2"
Tiles tiles_value(const Given& given);
/// --scale: "1:100" or "1cm=1m", as mm on the page for a mm in the world
double scale_value(const Given& given);

}  // namespace tactics
