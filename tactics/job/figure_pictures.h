// SPDX-License-Identifier: Apache-2.0
// Pixel pictures in a figure of lines: a recipe draws each in its own place.
#pragma once

#include <vector>

#include "tactics/job/drawable.h"
#include "tactics/page.h"

namespace tactics {

/// The drawable of one picture, and where the figure shows it.
struct FigurePart {
    Rect place;  ///< mm on the page of the figure
    Rect shown;  ///< the part that clipping leaves visible
    Drawable drawable;
};

/// Its placement in the figure.
Image turned_over(Image image, bool mirrored, bool upside_down);

/// Adds their print, except titles, to the print of the figure, which is `width` x `height` mm.
void take_words(const std::vector<FigurePart>& parts, double width, double height, PrintWords& words);

/// Adds the lines and areas of each to a drawing of the figure that is `scale` times as large. `with_words`: their print is set
/// in braille and removed from the lines.
void draw_parts(const std::vector<FigurePart>& parts, double scale, bool with_words, const Sheet& sheet, Drawing& figure,
                DrawingWay& way);

}  // namespace tactics
