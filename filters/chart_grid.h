// SPDX-License-Identifier: Apache-2.0
// Grid lines of a chart.
#pragma once

#include <utility>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/medium.h"
#include "tactics/page.h"

namespace tactics {

/// `lines`, each from an axis through the field, of short thin marks (on an embosser single dots) far from each other, so that a
/// finger feels less of them than of the axes. A mark that would come nearer than the medium's gap to anything that is drawn, or
/// into one of the `words`, is left out: lines break with blank space round data and braille (BANA 2.11, 3.4.3.13).
void draw_grid(Drawing& drawing, const std::vector<std::pair<Point, Point>>& lines, const std::vector<Rect>& words,
               const Medium& medium);

}  // namespace tactics
