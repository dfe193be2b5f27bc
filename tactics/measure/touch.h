// SPDX-License-Identifier: Apache-2.0
// The demands of a drawing on a hand: how much line, in how many pieces, and how much of it too close to be told apart.
#pragma once

#include <cstddef>

#include "tactics/drawing.h"

namespace tactics {

struct TouchLoad {
    double length = 0;  ///< mm of stroke
    std::size_t strokes = 0;
    double crowded = 0;  ///< mm of stroke that runs too close to another
};

/// A piece of stroke is crowded if a piece of another stroke, or of a far part of its own, is nearer than `least` (mm, between
/// middle lines). Lines may meet where one ends on another: parts within twice `least` of such a place, on either line, do not
/// crowd the other.
TouchLoad touch_load(const Drawing& drawing, double least);

}  // namespace tactics
