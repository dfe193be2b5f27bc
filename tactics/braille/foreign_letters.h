// SPDX-License-Identifier: Apache-2.0
// Words that may be in another language than their braille.
#pragma once

#include <string_view>

#include "tactics/text/phrase.h"

namespace tactics {

/// English braille has signs for letters of many languages, so a German title comes out without an error and is still not German
/// braille. What to tell of `title` in such a table: its Latin letters that English does not write, but for those of words that
/// it has taken over (café, naïve). Empty: there are none, or the table is not English.
Phrase note_of_foreign_letters(std::string_view title, std::string_view table);

}  // namespace tactics
