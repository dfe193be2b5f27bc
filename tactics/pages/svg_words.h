// What the letters of an SVG say: its texts, and letters drawn as shapes whose words stand beside them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/pages/svg.h"
#include "tactics/pages/transform.h"
#include "tactics/pages/xml.h"

namespace tactics {

/// The words of a text element, in each of its lines; `size` is its font's in its own units if it does not tell one.
/// `transform` gives mm.
std::vector<FoundWords> words_of_text(const Element& text, const Transform& transform);

/// Of a group or path whose letters are shapes: Inkscape says them in aria-label, Matplotlib in a comment. Empty: it is none.
std::string words_beside(const Element& element);

/// Of the whole drawing: its parts, and its metadata, have titles, too. Empty: none.
std::string title_of(const Element& root);

/// Matplotlib's "$\mathdefault{10^{2}}$" as "10²": what is no simple power stays as it is.
std::string without_markup(std::string_view text);

}  // namespace tactics
