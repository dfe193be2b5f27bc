// SPDX-License-Identifier: Apache-2.0
// Keeps curves that meet far enough apart for a finger.
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

/// Distances to keep, mm.
struct ApartWish {
    double gap = 0;    ///< from edge to edge
    double least = 0;  ///< minimum length of a remaining piece of a curve
    double rows = 0;   ///< from middle to middle at least: rows of dots
    /// Places that a curve may not go through: words, symbols. Empty: it may go everywhere.
    std::function<bool(std::size_t curve, Point place)> blocked = {};
};

/// The pieces of each curve: a curve keeps only the parts that are a gap away from earlier curves, in pieces no shorter than
/// `least`. So the later line is broken on both sides of a crossing, and two that run together are one line until they separate.
/// A curve that comes near itself, along a path over four times as long as the distance (kBend of the rule "gap"), is broken in
/// the same way. A piece that ends where it began is a whole closed line. Lines are simplified by 0.05 mm.
std::vector<std::vector<std::vector<Point>>> curves_apart(const std::vector<ApartCurve>& curves, const ApartWish& wish);

}  // namespace tactics
