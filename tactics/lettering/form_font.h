// SPDX-License-Identifier: Apache-2.0
// The letters of a font, ready to be held against ink.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/lettering/letter_form.h"

namespace tactics {

/// The letters of a font; a form is made when it is first asked for.
class FormFont {
public:
    /// `more` are its other letters, which are read when one of them is asked for; empty: it has none.
    explicit FormFont(FontShapes shapes, std::function<FontShapes()> more = {})
        : shapes_(std::move(shapes)), more_(std::move(more)) {}
    const LetterForm& form(char32_t code);   ///< an empty one: the font has no such letter
    const LetterForm& drawn(char32_t code);  ///< the same, drawn
    /// A code for those letters as one shape, for letters that touch; 0 if the font lacks one of them.
    char32_t join(std::u32string_view letters);
    std::u32string_view joined(char32_t code) const;  ///< empty: it is a letter
    const FontShapes& shapes();

private:
    const FontShape* shape_of(char32_t code);

    FontShapes shapes_;
    std::function<FontShapes()> more_;
    struct Joined {
        std::u32string letters;
        FontShape shape;
    };
    std::map<char32_t, LetterForm> forms_;
    std::vector<Joined> joined_;
};

/// Letters that figures have, in the order in which one is taken of those that look the same.
const std::vector<char32_t>& letters_of_figures();

}  // namespace tactics
