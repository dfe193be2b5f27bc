// SPDX-License-Identifier: Apache-2.0
// All lettering of a picture, read by the letters of the few fonts that it is in.
#pragma once

#include <string>
#include <vector>

#include "tactics/lettering/form_reader.h"

namespace tactics {

/// Another reader's result for a line.
struct OtherReading {
    std::string text;    ///< empty: nothing
    bool alike = false;  ///< it was read the same more than once
};

/// A line read by the letters of a font.
struct FormWords {
    FormReading reading;
    std::string text;      ///< with the letter that is meant where several look the same; empty: it is not of this font
    bool settled = false;  ///< it is clear which one is meant
    bool sized = false;    ///< other words of the picture are in that font and of that size without a doubt
    bool agreed = false;   ///< the other reader has the same text
    bool strange = false;  ///< it is of no font that is known: letters of several bear out what the other reader says
    int font = -1;         ///< number of the font; -1: none
};

/// The letter, which stands alone, is like its ink, or less so and unlike all others: print of few pixels.
bool is_alone_alike(const FormReading& reading);

/// A single letter that could easily be a drawn thing: a circle, a stroke, a cross.
bool may_be_drawn(char32_t code);

/// All of its letters are the same but for their size, small or capital.
bool is_of_either_case(const FormReading& reading);

/// One for each strip; none at all where no font is installed. Fonts are chosen by what the other reader made of the lines, or,
/// where that fits none, by what they look like.
std::vector<FormWords> read_in_fonts(const std::vector<InkStrip>& strips, const std::vector<OtherReading>& others,
                                     const PrintFonts& fonts);

}  // namespace tactics
