// SPDX-License-Identifier: Apache-2.0
// A line of lettering as the letters of a font read it.
#pragma once

#include <string>

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
    bool thin = false;     ///< its spaces are those of formulas
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

}  // namespace tactics
