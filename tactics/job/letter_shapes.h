// SPDX-License-Identifier: Apache-2.0
// Words of a figure whose letters are shapes, read by the outlines of installed fonts: no font is alike in all letters to
// another, so what is read is what was written, or nothing is.
#pragma once

#include "print/letters.h"
#include "tactics/readers/svg/found_page.h"

namespace tactics {

/// Asks for fonts one by one, as each_font does.
using Fonts = std::function<void(const std::function<bool(const FontLetters& font)>& goes_on)>;

/// Fills in the text of words that are letters drawn as shapes. Those with a letter that no font has stay empty.
void read_letter_shapes(FoundPage& figure, const Fonts& fonts = each_font);

}  // namespace tactics
