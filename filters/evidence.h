// Which lines matter most: the one place where strokes are ranked.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// How sure it is that a line is there: strength * sqrt(length). The mean of n samples of an edge stands out of noise by
/// sqrt(n) times what one sample does, so a long faint contour outweighs a short scratch, but not however faint.
/// Without strength (a drawing traced from black and white) the length alone.
double evidence_of(const Stroke& stroke);

/// Indices of the strokes, most evidence first; strokes without strength come after those with; equal ones keep their order.
std::vector<std::size_t> by_evidence(const std::vector<Stroke>& strokes);

}  // namespace tactics
