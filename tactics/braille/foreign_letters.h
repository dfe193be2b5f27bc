// SPDX-License-Identifier: Apache-2.0
// Detects words that may be in another language than their braille.
#pragma once

#include <string_view>

#include "tactics/text/phrase.h"

namespace tactics {

/// English braille has signs for letters of many languages, so a German title causes no error and is still not German braille.
/// Returns a message about `title` in such a table: its Latin letters that do not occur in English, except in adopted words
/// (café, naïve). Empty: there are none, or the table is not English.
Phrase note_of_foreign_letters(std::string_view title, std::string_view table);

}  // namespace tactics
