// SPDX-License-Identifier: Apache-2.0
// Five line styles for curves that a finger can tell apart.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/medium.h"

namespace tactics {

/// The number of styles that a finger can remember (TGwiki, Design Considerations: at most 5 line styles, else a key).
inline constexpr std::size_t kLineStyles = 5;

struct LineStyle {
    LineClass line = LineClass::normal;
    std::vector<double> marks = {};  ///< lengths of ink in mm, repeated; 0: a dot; empty: a solid line
    double gap = 0;                  ///< mm of white after each

    bool is_whole() const { return marks.empty(); }
};

/// Solid, dashed, thick, dotted and thick dashed lines; if the medium has no thick lines (an embosser), the third has a dot after
/// each dash and the fifth two. Dashes are 8 mm long with gaps of half of that (a rule file after BANA 3.4.3.3: 6 to 10 mm, about
/// half a dash). Where dots stand in cells of braille both grow, as a dot moves up to half the room between two cells: 10 mm, and
/// gaps of 5.4. Dots stand as far apart as the medium has gaps; those of thick lines are beads.
LineStyle line_style(std::size_t number, const Medium& medium);

/// The numbers of some of them.
inline constexpr std::size_t kDashedStyle = 1, kDottedStyle = 3, kThickDashedStyle = 4;

/// From the beginning of a sample to its end, mm: a finger meets each part of a style twice.
double sample_length(const Medium& medium);

/// A line in that style, each mark a stroke of Role::dash; the strokes keep all points of the line under ink. It begins and ends
/// with a mark, and marks and gaps are stretched for that, so that a line broken by another is recognisable after it.
std::vector<Stroke> in_style(const std::vector<Point>& points, bool closed, const LineStyle& style, const Medium& medium);

}  // namespace tactics
