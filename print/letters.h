// SPDX-License-Identifier: Apache-2.0
// Shapes of printed letters: the only door to fonts. PDF, PostScript and the formats of pixels draw these same shapes, so
// that a title looks and stands alike in all of them and no reader or printer needs the font. SVG keeps its words as text,
// to be read out and edited, and names the same font.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// A corner of an outline in thousandths of the letter size (em), y up from the baseline.
struct Corner {
    int x = 0;
    int y = 0;
};

/// Closed outlines, filled by the non-zero rule. A step is one corner (move, line) or three (cubic Bezier).
struct OutlineStep {
    enum class Kind { move, line, curve };
    Kind kind = Kind::move;
    Corner corners[3];
};

struct Letter {
    int advance = 0;  ///< to the next letter, in thousandths of em
    std::vector<OutlineStep> outline;
};

/// All letters of the page's print, by code point. DejaVu Sans; a letter that it lacks comes from a font that has it, or
/// as the font's sign for an unknown letter. Without any font, letters have no outline and an advance of half an em.
/// Throws Error(failed) where FONTCONFIG_FILE is a device.
std::map<char32_t, Letter> letters_of(const Page& page);

/// How programs bend outlines of letters to the pixels of a screen, and leave them so in files.
enum class Hinting { none, light, full };

/// Of one font those of these letters that it has; bent to pixels at that many pixels for an em.
using FontLetters = std::function<std::map<char32_t, Letter>(const std::vector<char32_t>& codes, Hinting hinting, double pixels)>;

/// Looks at one installed font with outlines after the other, those first that plotting and drawing programs take where nothing
/// is told, until `goes_on` says no; at 300 at most.
void each_font(const std::function<bool(const FontLetters& font)>& goes_on);

}  // namespace tactics
