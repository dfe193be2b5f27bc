// SPDX-License-Identifier: Apache-2.0
// Ranks strokes by importance, in this one place.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// The evidence for a line: strength * length^0.25. A long line outweighs a short scratch of the same strength, but not by much,
/// because the end of a line changes more easily than its strength. Measured on 60 photographs of BSDS500: of the line drawn at a
/// budget of 2.4 sides, people had marked 0.56 (strength alone), 0.60 (* length^0.25), 0.59 (* sqrt(length)), 0.59 (* length) and
/// 0.52 (length alone). Between a photograph and its copy with noise, 0.95 of the line stays with length^0.25, 0.91 with
/// sqrt(length). Without strength (a drawing traced from black and white) the length alone.
double evidence_of(const Stroke& stroke);

/// Indices of the strokes, most evidence first; strokes without strength come after those with; equal ones keep their order.
std::vector<std::size_t> by_evidence(const std::vector<Stroke>& strokes);

}  // namespace tactics
