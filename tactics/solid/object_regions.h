// SPDX-License-Identifier: Apache-2.0
// What a folded model tells of its objects: where each lies in the drawing, and what was done with it.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/solid/folded_objects.h"

namespace tactics {

/// A region for each object: of what is drawn all that was laid down of it, a slender part as a strip that a finger does not
/// miss. `seen` is how what is parallel to the plane is seen: "from above".
std::vector<Region> object_regions(const std::vector<FoldedObject>& objects, const std::vector<ModelPart>& felt,
                                   const Panels& panels, const FlatLayout& layout, const IntoDrawing& into, const Phrase& seen);

/// What a drawing has that wants a word: dashed lines, thick ones, wedges, things that were moved apart.
std::vector<Phrase> fold_remarks(const Drawing& drawing, const Phrase& seen, double spread);

/// In an order to be read, from the top down and from left to right, but what lies over others behind them.
std::vector<Region> in_reading_order(std::vector<Region> regions, const std::vector<double>& height);

}  // namespace tactics
