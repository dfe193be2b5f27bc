// SPDX-License-Identifier: Apache-2.0
// The shape of a line to a finger that follows it: a straight line, an arc, a circle, a rectangle ... Geometry only; the code
// does not guess what it depicts.
#pragma once

#include <span>
#include <vector>

#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct Shape {
    Phrase name;          ///< "circle", "straight horizontal line"; without article
    Phrase area;          ///< the same of what is not an outline but filled: "circle", "winding shape"
    Phrase size;          ///< "5 cm across"
    bool closed = false;  ///< in effect: ignores a gap too small for a finger
    bool level = false;   ///< straight, and horizontal or vertical
    double length = 0;    ///< mm, with the closing side
    Rect box;
    std::vector<Point> corners;  ///< the same line within 0.5 mm, coarser if that takes more than 200 points
};

/// `points` must not be empty.
Shape shape_of(std::span<const Point> points, bool closed);

bool cross(const Shape& a, const Shape& b);             ///< both continue beyond the crossing
bool holds(const Shape& ring, Point point);             ///< `ring` is closed
bool is_inside(const Shape& shape, const Shape& ring);  ///< entirely; always false for an open `ring`
bool end_meets(const Shape& open, const Shape& other);  ///< one of its ends reaches the other; always false if it is closed

double length_of(std::span<const Point> points, bool closed);

/// A length as people say it: "8 mm", "3.5 cm", "12 cm", "1.4 m".
Phrase spoken_length(double mm);
/// "5 cm wide and 3 cm high"
Phrase spoken_size(const Rect& box);

}  // namespace tactics
