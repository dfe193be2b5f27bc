// SPDX-License-Identifier: Apache-2.0
// The choices for pages, in terms of the command line, as compared by --update.
#pragma once

#include "cli/command.h"
#include "cli/request.h"

namespace tactics {

/// The program's version, every given option of `command` that can change pages, with its value, and the kept choices
/// (kept_choices.h). Files count by their contents; labels are not included, because each picture has its own.
MadeWith page_choices(const Command& command, const Given& given, const RecipeWish& recipe);

/// Whether that option can change pages: true for any option except those listed.
bool changes_pages(std::string_view flag);

}  // namespace tactics
