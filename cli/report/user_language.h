// SPDX-License-Identifier: Apache-2.0
// The language of whoever sits at the terminal, for messages and help. What is made for readers has that of its page instead, and
// what programs read is English.
#pragma once

#include <string>

#include "tactics/text/phrase.h"

namespace tactics {

/// A tag of a catalogue (tactics/text/catalogue.h), or "en": by LANGUAGE, a list such as de:fr, unless the locale is C, then by
/// the first of LC_ALL, LC_MESSAGES and LANG that is set, as gettext has it. A locale that is not in UTF-8 gets English, as its
/// letters could not be shown. Read once.
const std::string& user_language();

/// A number, with a decimal point, as that language writes it: "0,061".
std::string for_user(std::string number);

/// A phrase in that language, as a line of its own.
std::string line_for_user(const Phrase& words);

/// The language for other values of these variables; nullptr: not set.
std::string language_of_locale(const char* language, const char* lc_all, const char* lc_messages, const char* lang);

}  // namespace tactics
