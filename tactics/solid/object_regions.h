// SPDX-License-Identifier: Apache-2.0
// The description of a folded model's objects: where each lies in the drawing, and what was done with it.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/solid/folded_objects.h"

namespace tactics {

/// A region for each object: of what is drawn all that was laid down of it, a slender part as a strip that a finger does not
/// miss. The section and the bottom of a vessel have their own. `seen` is how what is parallel to the plane is seen: "from
/// above".
std::vector<Region> object_regions(const std::vector<FoldedObject>& objects, const std::vector<ModelPart>& felt,
                                   const Panels& panels, const FlatLayout& layout, const IntoDrawing& into, const Phrase& seen);

/// Things in a drawing that need an explanation: dashed lines, thick lines, wedges, things moved apart.
std::vector<Phrase> fold_remarks(const Drawing& drawing, const std::vector<FoldedObject>& objects, const Phrase& seen,
                                 double spread);

/// In reading order, from the top down and from left to right, except that things on top of others come after them.
std::vector<Region> in_reading_order(std::vector<Region> regions, const std::vector<double>& height);

}  // namespace tactics
