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

/// If there is more than `times` the line that could stand side by side, removes the thinnest lines with the least evidence, so
/// that the rest can be examined.
Mends thin_out(Drawing& drawing, const Medium& medium, double times);

/// Heads of arrows that end right before what they point to go back along their shafts until there is a gap (rule arrow-gap),
/// where the shaft is long enough.
Mends draw_back_heads(Drawing& drawing, const Medium& medium, Seen& seen);

/// Ends that nearly meet a line, and point to it, are led onto it.
Mends join_ends(Drawing& drawing, const Medium& medium, Seen& seen);

/// Bends lines that are too close away from each other, each by at most kFarthestMove. Lines that end on another move with it.
/// Areas stay. Nothing if that does not help: then the drawing is unchanged. Bends too small to mention are not among the
/// changes.
std::optional<Mends> move_apart(Drawing& drawing, const Medium& medium);

/// A fingertip resolves about 25 dots per inch (R. E. Ladner and others): a thing that moves by less feels as if in the same
/// place.
inline constexpr double kFarthestMove = 1;  // mm

/// Where small areas are too close to others, lines that only go round one of them go, of all small areas alike, so that they
/// stay alike; true: some went. What is drawn stays, by half a line's width smaller.
bool drop_rims(Drawing& drawing, Seen& seen);

/// Small areas that are too close to others, as points of a chart are, move away as they are, each by at most kFarthestMove.
/// Nothing if that does not help.
Mends move_areas_apart(Drawing& drawing, const Medium& medium, Seen& seen);

/// Where all points of a drawing, its small compact areas, are of one size and too close to each other, all become smaller alike,
/// to kFoundPoint at least. Nothing if that does not help, or if lines touch them.
Mends shrink_areas(Drawing& drawing, const Medium& medium, Seen& seen);

/// So large is a small area that a finger finds among others; own choice, half a millimetre more than a braille dot.
inline constexpr double kFoundPoint = 2;  // mm

/// Points of one size smaller than a braille dot become as large as one, if all have room for it within the drawing.
Mends enlarge_specks(Drawing& drawing, const Medium& medium);

/// Areas that are too close to others, or have slits that are too narrow, become outlines; small ones go. Others may then be
/// too close across the place that became free.
Mends outline_areas(Drawing& drawing, Seen& seen);

/// If the page is too black, turns the largest areas into outlines.
Mends lighten(Drawing& drawing, const Medium& medium);

/// Where lines cross, gives the lesser line a gap on both sides of the other. `geometry` is the drawing's.
Mends break_crossings(Drawing& drawing, const Medium& medium, const PageGeometry& geometry);

/// Takes away what is too close, by more than `lacks` mm, to something of more worth. Once may not be enough, as new ends come
/// near to others; they do so in `changed` only.
Mends cut_lesser(Drawing& drawing, const Medium& medium, Seen& seen, double lacks, Vicinity& changed);

/// The remaining runs of pieces of a stroke, as strokes, without those shorter than `shortest`. `gone` has a flag for each piece
/// of the chain. Records the changes; a removed run beside another line that is longer than `along` is reported as merged.
std::vector<Stroke> without(const Stroke& stroke, const PageGeometry& geometry, const Chain& chain, const std::vector<bool>& gone,
                            double shortest, double along, Mends& changes);

}  // namespace tactics
