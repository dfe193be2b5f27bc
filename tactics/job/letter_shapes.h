// SPDX-License-Identifier: Apache-2.0
// Words whose letters are drawn as shapes, read by the outlines of installed fonts. No two fonts agree in all letters, so a word
// is read as it was written, or not at all.
#pragma once

#include "print/letters.h"
#include "tactics/readers/svg/found_page.h"

namespace tactics {

/// Visits fonts one by one, as each_font does.
using Fonts = std::function<void(const std::function<bool(const FontLetters& font)>& goes_on)>;

/// Fills in the text of words whose letters are drawn as shapes. Words with a letter that no font has stay empty.
void read_letter_shapes(FoundPage& figure, const Fonts& fonts = each_font);

}  // namespace tactics
