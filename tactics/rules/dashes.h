// SPDX-License-Identifier: Apache-2.0
// Dashed lines as they stand on a page.
#pragma once

#include <vector>

#include "tactics/rules/page_geometry.h"

namespace tactics {

/// Mm of a line with its round ends, as a finger meets it.
inline double felt_length(const Chain& chain) { return chain.length + 2 * chain.half_width; }

/// A mark no longer than wide is a dot, of a dotted line or between two dashes; the rules for dashes do not apply to it.
inline bool is_dot(const Chain& chain) { return chain.length <= 2 * chain.half_width; }

/// A line's dashes (chains) stand in their order on the page; what is farther from the last one than two of it, or not in
/// its direction, begins another line.
using DashedLine = std::vector<std::size_t>;
std::vector<DashedLine> dashed_lines(const PageGeometry& geometry);

/// Between the ink of a dash and that of the next one.
double dash_gap(const PageGeometry& geometry, std::size_t dash, std::size_t next);

}  // namespace tactics
