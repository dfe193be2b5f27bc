// SPDX-License-Identifier: Apache-2.0
// Draws textures: the lines and dots that fill areas on a page.
#pragma once

#include "tactics/page.h"

namespace tactics {

/// Adds the marks of all textured areas to the page's strokes, as Role::pattern. They keep the medium's gap from everything
/// already on the page, and half of it from the border of their own area, so that adjacent textures are a full gap apart. With
/// fixed dots they lie on the page's cells, an empty row of dots away from any line. All areas of one texture are cut from one
/// pattern that covers the page. At most about half a million marks: beyond that, they are drawn wider apart.
///
/// `cells`: the live area that defines the cells: that of the first sheet if the page is cut into several.
void draw_patterns(Page& page, const Medium& medium, const Rect& cells);
inline void draw_patterns(Page& page, const Medium& medium) { draw_patterns(page, medium, Rect(page.live)); }

}  // namespace tactics
