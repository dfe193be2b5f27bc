// SPDX-License-Identifier: Apache-2.0
// The language of a page and its braille table.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "tactics/layout/sheet.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// --language and --braille override the kept choices. A language brings its table if none is named; a kept table applies only
/// with its own language. `notes` gets the choice. Throws Error(usage).
void plan_language(Sheet& sheet, const Given& given, std::vector<Phrase>& notes);

}  // namespace tactics
