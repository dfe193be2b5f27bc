// SPDX-License-Identifier: Apache-2.0
// What the letters of an SVG say: its texts, and letters drawn as shapes whose words stand beside them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/svg/found_page.h"
#include "tactics/readers/svg/svg_fonts.h"
#include "tactics/readers/svg/svg_style.h"
#include "tactics/readers/svg/transform.h"
#include "tactics/readers/xml.h"

namespace tactics {

/// What the words of a text depend on elsewhere in the file.
struct TextNeeds {
    std::function<Style(const Element& part, const Style& outer)> style_of;
    std::function<const Element*(std::string_view id)> element;            ///< nullptr: there is none
    std::function<const LetterWidths&(std::string_view families)> widths;  ///< of a font of the file; empty: it has none
};

/// The words of a text element, in each of its lines or wherever it goes on. `transform` gives mm; `style` is the element's.
std::vector<FoundWords> words_of_text(const Element& text, const Transform& transform, const Style& style,
                                      const TextNeeds& needs);

/// Puts them behind the others, unless the last ones say the same at the same place: a light edge is often drawn beneath letters.
void add_words(std::vector<FoundWords>& all, std::vector<FoundWords> more);

/// Of a group or path whose letters are shapes: Inkscape says them in aria-label, Matplotlib in a comment. Empty: it is none.
std::string words_beside(const Element& element);

/// Words whose letters, as shapes, fill that box; with as many lines as the comment beside them.
FoundWords words_in_box(std::string words, const Rect& box, std::string_view comment);

/// Of the whole drawing: its parts, and its metadata, have titles, too. Empty: none.
std::string title_of(const Element& root);

/// The letters of a formula stand in the file font by font, so what was found of them from `from` on says it in a wrong order;
/// the words beside them say it right.
void say_right(std::vector<FoundWords>& words, std::size_t from, const std::string& right);

}  // namespace tactics
