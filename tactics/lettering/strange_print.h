// SPDX-License-Identifier: Apache-2.0
// Print in a font that is not installed: what another reader says is held against the letters of all fonts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/lettering/form_reader.h"

namespace tactics {

/// The line with the letters of `told` if each of its pieces of ink may be the letter that is said to be there: it looks like it
/// in one of `fonts`, is about as large and as high as in the first of them, and looks no more like another letter in the first
/// few. The fonts that fit it best come first. Likeness is that to the likest font. `text` is as it was told; empty: its
/// gaps are other ones.
std::optional<FormReading> bear_out(const InkStrip& strip, const std::string& told, const std::vector<FormFont*>& fonts);

/// Its capitals are not all as high as each other, or its small letters are not: one was taken for the other.
bool is_of_mixed_case(const FormReading& reading);

/// Of two texts with the same letters, the one that has spaces where the gaps are; nothing if the gaps do not tell.
std::optional<std::string> with_its_gaps(const FormReading& reading, const std::string& one, const std::string& other);

/// A word of it has nothing but figures and letters that look like some, as "7O" has and, in print of no known font, "IO".
bool may_be_figures(std::string_view text, bool strange);

}  // namespace tactics
