// SPDX-License-Identifier: Apache-2.0
// A drawing of filled surfaces as one of lines, so that each surface is closed, and shares its sides with its neighbours and with
// the axis that it stands on.
#pragma once

#include "filters/filled_parts.h"
#include "tactics/image.h"

namespace tactics {

/// The parts get the colour of the ground, and a line where they end: between two of them, or in the middle of a thin line that
/// is there already. What is drawn on them stays as far from the ground as it was from their colour. Lines of hatches go.
void draw_by_outlines(Image& picture, const FilledParts& fills);

}  // namespace tactics
