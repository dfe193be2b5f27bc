// SPDX-License-Identifier: Apache-2.0
// A table of numbers as a plot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/job/table_wish.h"
#include "tactics/plot.h"
#include "tactics/readers/read.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Rows are joined in order. Where y is unknown, a curve has a gap; rows without an x are left out, and `notes` says how many. A
/// curve of one point is a ring, and so is a point between two gaps. Throws Error: usage for a wish that names no column or more
/// columns than a finger can tell apart, and failed, with the line, for a value that is no number. A pair of numbers takes 16
/// bytes, and twice that while the curve grows.
Plot plot_of(Source& source, const TableWish& wish, std::vector<Phrase>& notes);

/// Whether plot_of looks for heights over x and y in it, by its wish and its first rows; it may still find points in space.
/// Rewinds it. Throws Error as plot_of does.
bool is_of_heights(Source& source, const TableWish& wish);

/// The surface of a table of heights; nothing if the table holds points in space, or curves. Throws Error as plot_of does.
std::optional<PlotSurface> surface_in(Source& source, const TableWish& wish, std::vector<Phrase>& notes);

}  // namespace tactics
