// The braille cells of two standards, to measure those of a page by.
//
// NLS Specification 800 (as BANA gives it): 2.34 mm from dot to dot, 6.2 from cell to cell, 10.0 from line to line. Marburg
// Medium (SONS P4008055): 2.5 mm within 4 %, 6.0 within 10 %, 10.1 within 9 %.
#pragma once

#include <algorithm>
#include <cmath>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

inline constexpr CellSize kNls{2.34, 6.2, 10.0};
inline constexpr CellSize kMarburg{2.5, 6.0, 10.1};

/// How far it is from the nearer of the two.
inline double off_standard(double pitch, double one, double other) {
    return std::min(std::abs(pitch - one), std::abs(pitch - other));
}

/// The place of a page's first braille; nothing without braille.
inline std::optional<Point> first_braille(const PageGeometry& geometry) {
    if (geometry.braille.empty()) return std::nullopt;
    return Point{geometry.braille[0].left, geometry.braille[0].top};
}

}  // namespace tactics
