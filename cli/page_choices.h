// SPDX-License-Identifier: Apache-2.0
// What was chosen for pages, in the words of the command line: what --update compares.
#pragma once

#include "cli/command.h"
#include "cli/request.h"

namespace tactics {

/// The program's version, every option of `command` that was given and that may make other pages, with its value, and what is
/// kept (kept_choices.h). Files count by what is in them; labels are not among them, as each picture has its own.
MadeWith page_choices(const Command& command, const Given& given, const RecipeWish& recipe);

/// Whether that option may make other pages. Those that may not are named; any other may.
bool changes_pages(std::string_view flag);

}  // namespace tactics
