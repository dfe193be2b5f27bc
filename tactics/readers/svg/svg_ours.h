// SPDX-License-Identifier: Apache-2.0
// What a file of our own tells of itself in classes: what lines are for, where patterns are, what braille says. Other programs
// keep classes when the file goes through them.
#pragma once

#include <optional>
#include <vector>

#include "tactics/page.h"
#include "tactics/readers/svg/found_braille.h"
#include "tactics/readers/svg/transform.h"
#include "tactics/readers/xml.h"

namespace tactics {

Role role_told(const Element& shape);    ///< Role::line if it tells none
int texture_told(const Element& shape);  ///< 0: none
/// Of a group with braille of the page: the size of its cells, mm; `scale` is that of the group's units.
std::optional<CellSize> cell_told(const Element& group, double scale);
/// Of a group with a line of braille: its dots say what is told here, and need not be known again.
bool tells_cells(const Element& group);
/// Of a layer with print: words that are known already, as those of the braille.
bool tells_words(const Element& group);
/// A path that says where a thing of the drawing lies becomes a region of the page, and is not drawn, whoever painted it.
bool take_region(const Element& shape, const Transform& transform, Page& page);

/// What was drawn of such a group, or of one with the lines of a name, becomes the page's: the discs from `disc` on a line of
/// braille, unless dots were added, moved or taken away; the lines from `line` on those of a name.
void settle_group(const Element& group, const std::optional<CellSize>& cell, std::vector<Disc>& discs, std::size_t disc,
                  std::size_t line, Page& page);

}  // namespace tactics
