// SPDX-License-Identifier: Apache-2.0
// The language of a page and the table of braille that goes with it.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "tactics/layout/sheet.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// --language and --braille, each before what is kept. A language brings its table where none is named; a kept table stays with
/// its own language only. What it chose is told in `notes`. Throws Error(usage).
void plan_language(Sheet& sheet, const Given& given, std::vector<Phrase>& notes);

}  // namespace tactics
