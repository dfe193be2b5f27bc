// SPDX-License-Identifier: Apache-2.0
// What programs write twice, for readers that know more and for those that know less: words as HTML and as text, in a switch.
#pragma once

#include <string>
#include <vector>

#include "tactics/readers/svg/found_page.h"
#include "tactics/readers/svg/svg_shapes.h"
#include "tactics/readers/svg/svg_style.h"
#include "tactics/readers/svg/svg_words.h"
#include "tactics/readers/svg/transform.h"
#include "tactics/readers/xml.h"

namespace tactics {

struct SvgChoice {
    const Element* drawn = nullptr;  ///< nullptr: none
    std::string words;               ///< what its text should say, where that is cut off; empty: what it says
};

/// Of the children of a switch the one for every language, rather as SVG than as HTML; without such, the one for English, or else
/// the first.
SvgChoice chosen_in(const Element& choice);

/// A text, a foreignObject with HTML, or a flowRoot, which Inkscape wrote for a while and no other program shows.
bool has_words(const Element& element);

/// What it says. HTML stands where its box is, or where the style of its first part moves it, as draw.io does; the words of a
/// flowRoot stand in the middle of its region.
std::vector<FoundWords> words_in(const Element& element, const Transform& transform, const Style& style, const TextNeeds& needs,
                                 const SvgLengths& lengths);

}  // namespace tactics
