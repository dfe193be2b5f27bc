// SPDX-License-Identifier: Apache-2.0
// The scale bar: how large in the world what is drawn is.
#pragma once

#include "tactics/layout/sheet.h"
#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Mm that it takes from the room above it, what is kept clear included.
double scale_bar_height(const Sheet& sheet);

/// At the bottom left of `room`: as long as 6 cm and the room allow for a round length, what that is in the world beside it.
/// `scale` is mm on the page for a mm in the world. Throws Error(usage) if no length fits, or as to_braille does.
void set_scale_bar(Page& page, const Rect& room, double scale, const Sheet& sheet);

/// A length in the world, to three digits: "5 m", "2.5 km".
Phrase real_length(double mm);

}  // namespace tactics
