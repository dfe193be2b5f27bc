// SPDX-License-Identifier: Apache-2.0
// The deviation of a page's braille from the cells of the standards (cells.inc).
#pragma once

#include <algorithm>
#include <cmath>

#include "tactics/rules/page_geometry.h"
#include "tactics/rules/rule.h"

namespace tactics {

/// The least distance from line to line of any standard.
inline constexpr double kLeastLinePitch = 10;

/// The deviation from the nearest standard that defines this value.
inline double off_standard(double pitch, double CellSize::*has) {
    double off = 1e9;
    for (const NamedCell& cell : cells()) off = std::min(off, std::abs(pitch - cell.size.*has));
    return off;
}

/// The place of a page's first braille; nothing without braille.
inline std::optional<Point> first_braille(const PageGeometry& geometry) {
    if (geometry.braille.empty()) return std::nullopt;
    return Point{geometry.braille[0].left, geometry.braille[0].top};
}

}  // namespace tactics
