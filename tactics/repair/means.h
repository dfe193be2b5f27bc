// SPDX-License-Identifier: Apache-2.0
// The means of repair, each a pass over the drawing that says what it did. In the order of repair.h. `seen` is the drawing as it
// comes.
#pragma once

#include <optional>
#include <vector>

#include "tactics/repair/near.h"
#include "tactics/repair/repair.h"

namespace tactics {

using Mends = std::vector<Mend>;

/// Of more line than could stand side by side `times` over, the thinnest lines with the least evidence go, so that the rest can
/// be looked at.
Mends thin_out(Drawing& drawing, const Medium& medium, double times);

/// Ends that nearly meet a line, and point to it, are led onto it.
Mends join_ends(Drawing& drawing, const Medium& medium, const Seen& seen);

/// Lines that are too close bend away from each other, by kFarthestMove at most each. What ends on another line goes with it.
/// Areas stay. Nothing, if that does not help: then all stays as it is. Bends too small for a word are none of the changes.
std::optional<Mends> move_apart(Drawing& drawing, const Medium& medium);

/// A fingertip tells about 25 dots an inch (R. E. Ladner and others): what moves by that is felt at the same place.
inline constexpr double kFarthestMove = 1;  // mm

/// Areas that are too close to others, or have slits that are too narrow, become outlines; small ones go.
Mends outline_areas(Drawing& drawing, const Seen& seen);

/// Where the whole is too black, the largest areas become outlines.
Mends lighten(Drawing& drawing, const Medium& medium);

/// Where lines cross and one is less than the other, it gets a gap on both sides of the other.
/// `geometry` is the drawing's.
Mends break_crossings(Drawing& drawing, const Medium& medium, const PageGeometry& geometry);

/// Takes away what is too close, by more than `lacks` mm, to something of more worth. Once may not be enough, as new ends come
/// near to others; they do so in `changed` only.
Mends cut_lesser(Drawing& drawing, const Medium& medium, const Seen& seen, double lacks, Vicinity& changed);

/// Of a stroke the runs of pieces that stay, as strokes; what is shorter than `shortest` goes. `gone` has a flag for each piece
/// of the chain. Adds what was done; a run beside another line that is longer than `along` is told as merged.
std::vector<Stroke> without(const Stroke& stroke, const PageGeometry& geometry, const Chain& chain, const std::vector<bool>& gone,
                            double shortest, double along, Mends& changes);

}  // namespace tactics
