// SPDX-License-Identifier: Apache-2.0
// Textures drawn: the lines and dots that fill areas on a page.
#pragma once

#include "tactics/page.h"

namespace tactics {

/// Adds the marks of all textured areas to the page's strokes, as Role::pattern. They keep the medium's gap from everything
/// that is on the page already, and half of it from the border of their own area, so that two textures beside each other
/// stand apart by the whole. With fixed dots they stand on the page's cells, an empty row of dots from any line. All areas of
/// one texture are cut from one pattern that lies over the page. At most about half a million marks: beyond that they are
/// drawn wider apart.
///
/// `cells`: the live area whose cells count, of the first sheet of several that the page is cut into.
void draw_patterns(Page& page, const Medium& medium, const Rect& cells);
inline void draw_patterns(Page& page, const Medium& medium) { draw_patterns(page, medium, Rect(page.live)); }

}  // namespace tactics
