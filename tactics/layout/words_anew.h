// SPDX-License-Identifier: Apache-2.0
// Words of a page that a person has changed, moved or added, set where they stand.
#pragma once

#include <string>

#include "tactics/layout/key.h"
#include "tactics/layout/sheet.h"
#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The sheet of a page as far as it tells: its medium, braille, language and title. Paper and margins stay open.
Sheet sheet_of(const Page& page);

/// An entry of the key, from the page's own words. Throws as to_braille.
KeyEntry key_entry(const PageWords& words, const Page& page);

/// These words say something else now: their braille and print are set anew, from where they began, on the side of what they
/// name. Gives what a person should look at, or nothing. Throws Error(usage) as to_braille does.
Phrase set_words_anew(Page& page, int words, const std::string& text);

/// Moves their braille, and what is known of its place. Lead lines that end there follow.
void move_words(Page& page, int words, double right, double down);

/// Their braille has been moved by so much: what is known of its place follows, as in move_words.
void follow_words(Page& page, int words, double right, double down);

/// New words whose braille (or print, if the page has no braille) begins there. Throws as set_words_anew.
void add_words(Page& page, Point at, const std::string& text);

}  // namespace tactics
