// SPDX-License-Identifier: Apache-2.0
// Parts of charts that serve the eye: grids, and legends, which explain by colours what a finger cannot see.
#pragma once

#include <cstddef>

#include "tactics/readers/svg/found_page.h"
#include "tactics/readers/svg/svg_ground.h"
#include "tactics/readers/svg/svg_style.h"

namespace tactics {

/// Notes how the element was painted that drew the strokes and areas from these numbers on.
void add_look(FoundPage& figure, std::size_t strokes, std::size_t areas, const Style& style, const Ground& ground);

/// Grids go; the words of a legend name the curve or surface that looks like the sample beside them, and the sample goes. Both
/// are told in the notes.
void tidy_chart(FoundPage& figure, bool with_words);

/// The part of `tidy_chart` that sees to legends: marks strokes that go by taking their points away.
void name_by_legend(FoundPage& figure);

/// Around all that was drawn of it; of no size if nothing was.
Rect box_of(const FoundPage& figure, const FoundLook& look);

}  // namespace tactics
