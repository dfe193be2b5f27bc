// SPDX-License-Identifier: Apache-2.0
// Shapes of printed letters; the only access to fonts. PDF, PostScript and the pixel formats draw these same shapes, so that a
// title looks the same in all of them and no reader or printer needs the font. SVG keeps its words as text, for screen readers
// and editing, and names the same font.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// A point of an outline in thousandths of the letter size (em), y upwards from the baseline.
struct LetterCorner {
    int x = 0;
    int y = 0;
};

/// Closed outlines, filled by the non-zero rule. A step has one point (move, line) or three (cubic Bezier).
struct OutlineStep {
    enum class Kind { move, line, curve };
    Kind kind = Kind::move;
    LetterCorner corners[3];
};

struct Letter {
    int advance = 0;  ///< distance to the next letter, in thousandths of em
    std::vector<OutlineStep> outline;
};

/// All letters of the page's print, by code point. DejaVu Sans; a missing letter comes from a font that has it, or is drawn as
/// the font's sign for an unknown letter. Without any font, letters have no outline and an advance of half an em. Throws
/// Error(failed) if FONTCONFIG_FILE is a device.
std::map<char32_t, Letter> letters_of(const Page& page);

/// How programs hint outlines of letters to the pixels of a screen, and save them in this form.
enum class Hinting { none, light, full };

struct FontLetters {
    /// Reads those of the given letters that the font has; hinted at that many pixels per em.
    using Of = std::function<std::map<char32_t, Letter>(const std::vector<char32_t>& codes, Hinting hinting, double pixels)>;
    Of plain;
    Of formula;  ///< as formulas in that font have them: Latin and small Greek letters slanted; empty: not known
};

/// Visits the installed outline fonts, first the default fonts of plotting and drawing programs and of TeX, until `goes_on`
/// returns false; at most 300. Their letters may be read later, too.
void each_font(const std::function<bool(const FontLetters& font)>& goes_on);

/// How far each letter of a font file (TrueType, OpenType, WOFF, WOFF2) reaches to the next, em; nothing: it has no such letter.
/// Empty: it is no font file.
std::function<std::optional<double>(char32_t code)> letter_widths_of(std::string file);

}  // namespace tactics
