// SPDX-License-Identifier: Apache-2.0
// Curves that come together, as a finger can still tell them apart.
#pragma once

#include <functional>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// A curve of one or more lines. A line that ends where it began is closed.
struct ApartCurve {
    std::vector<std::vector<Point>> lines;
    double width = 0;          ///< mm
    bool apart_itself = true;  ///< it keeps the gap from itself, too
};

/// How far what is drawn keeps apart, mm.
struct ApartWish {
    double gap = 0;    ///< from edge to edge
    double least = 0;  ///< a piece that is left of a curve is no shorter
    double rows = 0;   ///< from middle to middle at least: rows of dots
    /// Places that a curve may not go through: words, symbols. Empty: it may go everywhere.
    std::function<bool(std::size_t curve, Point place)> blocked = {};
};

/// The pieces of each curve: of each that follows only what keeps the gap from those before it, in pieces no shorter than
/// `least`. A line that is crossed is so broken on both sides of the crossing, and two that run together are one line until they
/// part. A curve that comes near itself, by a way that is over four times as long as what is between (kBend of the rule "gap"),
/// is broken in the same way. A piece that ends where it began is a whole closed line. Courses are simplified by 0.05 mm.
std::vector<std::vector<std::vector<Point>>> curves_apart(const std::vector<ApartCurve>& curves, const ApartWish& wish);

}  // namespace tactics
