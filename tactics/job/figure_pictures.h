// SPDX-License-Identifier: Apache-2.0
// Pictures of pixels that stand in a figure of lines: each is drawn by a recipe, in its own place.
#pragma once

#include <vector>

#include "tactics/job/drawable.h"
#include "tactics/page.h"

namespace tactics {

/// What draws one, and where the figure shows it.
struct FigurePart {
    Rect place;  ///< mm on the page of the figure
    Rect shown;  ///< what clips leave of it
    Drawable drawable;
};

/// As it stands in the figure.
Image turned_over(Image image, bool mirrored, bool upside_down);

/// Their print becomes print of the figure, which is `width` x `height` mm, but no titles.
void take_words(const std::vector<FigurePart>& parts, double width, double height, PrintWords& words);

/// Lines and areas of each, laid into a drawing of the figure that is `scale` times as large. `with_words`: their print is set in
/// braille, and leaves the lines.
void draw_parts(const std::vector<FigurePart>& parts, double scale, bool with_words, const Sheet& sheet, Drawing& figure,
                DrawingWay& way);

}  // namespace tactics
