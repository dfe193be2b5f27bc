// SPDX-License-Identifier: Apache-2.0
// The scale bar, which shows the real size of the drawing.
#pragma once

#include "tactics/layout/sheet.h"
#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Height that it takes from the room above it, including the clear space, mm.
double scale_bar_height(const Sheet& sheet);

/// Draws it at the bottom left of `room`: the longest round length within 6 cm and the room, with its real length beside it.
/// `scale` is mm on the page per mm in the world. Throws Error(usage) if no length fits, or as to_braille does.
void set_scale_bar(Page& page, const Rect& room, double scale, const Sheet& sheet);

/// A real length, to three digits: "5 m", "2.5 km".
Phrase real_length(double mm);

}  // namespace tactics
