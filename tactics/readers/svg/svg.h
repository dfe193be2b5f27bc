// SPDX-License-Identifier: Apache-2.0
// A page read from an SVG file, whoever drew it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "tactics/readers/svg/found_page.h"
#include "tactics/readers/svg/svg_fonts.h"

namespace tactics {

/// A page is looked at as a printer shows it. A figure is drawn anew: colours and light greys are lines, too, coloured surfaces
/// become their outlines, letters become words, and what lies outside of a rectangle that cuts it is left out.
/// Whose words are not wanted has `lines` only: there a legend keeps its samples.
enum class SvgPurpose { page, figure, lines };

/// Fills in the text of words that are drawn as shapes (FoundWords::letters), as far as it knows these shapes.
using LetterReader = std::function<void(FoundPage& figure)>;

/// Lines, curves and shapes in what is darker than half grey become strokes and areas, with their transforms, widths and
/// simple style sheets; small discs that stand as cells do become braille; one picture within the file stays a picture.
/// White drawn over black is not taken as erasing. `paper` is for a file that tells no size. `open_font` tells how wide letters
/// of fonts within the file are, on which the gaps between its words depend. Throws Error(failed).
FoundPage read_svg(std::string_view bytes, const std::string& file, double margin, const std::optional<Paper>& paper,
                   SvgPurpose purpose = SvgPurpose::page, const LetterReader& read_letters = {},
                   const FontOpener& open_font = {});

}  // namespace tactics
