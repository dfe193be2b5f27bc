// SPDX-License-Identifier: Apache-2.0
// What is round, as panels: its ends, and what it looks like from the side. With closed outlines, readers confused the opening of
// a pot with its bottom (M. Kurze, CHI 1997, fig. 8): a vessel has a section, which is open where it is, between its opening and
// its bottom.
#pragma once

#include <cstdint>

#include "tactics/solid/panel.h"

namespace tactics {

/// Of a part that is round; `number` is its place in the list.
void add_round(Panels& made, const ModelPart& part, std::uint32_t number, const ViewPlane& view);

}  // namespace tactics
