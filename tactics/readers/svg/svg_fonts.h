// SPDX-License-Identifier: Apache-2.0
// Fonts that an SVG brings along: how wide their letters are.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "tactics/readers/xml.h"

namespace tactics {

/// How far a letter reaches to the next, em; nothing: the font has it not.
using LetterWidths = std::function<std::optional<double>(char32_t code)>;

/// Opens a font file (TrueType, OpenType, WOFF, WOFF2). Empty: it is none.
using FontOpener = std::function<LetterWidths(std::string file)>;

/// The fonts of a drawing, as @font-face of its style sheets (CSS Fonts 3, section 4) and as elements (SVG 1.1, chapter 20).
class SvgFonts {
public:
    /// `open` may be empty: then those of style sheets are not known.
    explicit SvgFonts(FontOpener open) : open_(std::move(open)) {}

    /// `element` and all in it, which outlive this.
    void know(const Element& element);

    /// By the first of these names; empty: the drawing has no such font.
    const LetterWidths& widths_of(std::string_view families);

private:
    struct Font {
        const Element* element = nullptr;
        std::string_view address;  ///< or a data URI
        bool opened = false;
        LetterWidths widths;
    };

    void know_sheet(std::string_view sheet);

    FontOpener open_;
    std::map<std::string, Font, std::less<>> fonts_;
};

}  // namespace tactics
