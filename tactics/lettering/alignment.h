// SPDX-License-Identifier: Apache-2.0
// Which ink of a line is which letter of a text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/lettering/form_font.h"
#include "tactics/lettering/ink_letters.h"

namespace tactics {

/// em; a point or a dash is lower, and is told by its place. A setting.
inline constexpr double kLowForm = 0.3;

/// A letter and its ink: whole units of the strip, as thin strokes come apart, or a part of one that letters share which touch.
struct AlignedLetter {
    char32_t code = 0;
    std::size_t first = 0, last = 0;  ///< units
    bool shared = false;
    InkBox box;
    double likeness = 0;  ///< of what it shares, too
};

struct AlignedLine {
    double em = 0;        ///< pixels
    double foot = 0;      ///< where the line is that letters stand on, pixels of the strip
    double likeness = 0;  ///< mean, by width
    std::vector<AlignedLetter> letters;
};

/// Each of `letters` (no spaces) gets ink, and all ink a letter, as they fit best in that font; nothing if they do not fit.
std::optional<AlignedLine> align(const InkStrip& strip, FormFont& font, const std::u32string& letters);

}  // namespace tactics
