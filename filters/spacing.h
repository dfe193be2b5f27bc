// SPDX-License-Identifier: Apache-2.0
// Keeps lines far enough apart for a finger.
#pragma once

#include "tactics/drawing.h"
#include "tactics/layout/texture.h"

namespace tactics {

/// The amount by which simplify may narrow a gap afterwards: its tolerance on both sides.
inline constexpr double kMovedLater = 0.2;  // mm

/// Of the least length of lines: what leads from one line to another says more than a loose piece, if it is whole.
inline constexpr double kShareBetween = 0.5;

/// Width of an area whose texture keeps `clear` from the lines around it and is felt, mm. Rows of a pattern begin where they
/// begin on the page, not where the area does: that can take a row.
inline double width_for_texture(double clear) {
    constexpr double kRow = 2;
    return kLeastTexture + 2 * clear + kRow;
}

/// Takes strokes in order of their evidence, cuts away the parts of each that run within `gap` (between middle lines) of an
/// earlier one, or of an earlier part of itself, and drops pieces shorter than `shortest`, or half of that between two lines. A
/// line that ends on another at a steep angle keeps its end, which is extended onto it, and a line on which earlier ones end goes
/// on; at a crossing the lesser line is broken. The two sides of a thin bar become one line.
void keep_apart(Drawing& drawing, double gap, double shortest);

}  // namespace tactics
