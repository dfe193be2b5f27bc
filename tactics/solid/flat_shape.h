// SPDX-License-Identifier: Apache-2.0
// Shapes of a layout, and whether two of them are in each other's way.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/box.h"

namespace tactics {

/// Rings by the even-odd rule, mm; and the upright box round them.
struct FlatShape {
    std::vector<std::vector<Point>> rings;
    Box box = kNothing;
};
/// Makes the first hold the second, too.
inline void take(Box& box, const Box& other) {
    box.take({other.left, other.top});
    box.take({other.right, other.bottom});
}
FlatShape flat_shape(std::vector<std::vector<Point>> rings);

enum class ShapeMeeting {
    apart,     ///< or touching along their borders
    crossing,  ///< a border of one goes through the other
    inside,    ///< the first lies in the second
    round,     ///< the first lies round the second
};

/// Points closer than `touching` to a border are on it, mm.
ShapeMeeting meeting_of(const FlatShape& one, const FlatShape& other, double touching);
/// The same for a straight line: inside, crossing or apart.
ShapeMeeting meeting_of(Point from, Point to, const FlatShape& shape, double touching);
/// Two straight lines cross, more than at an end.
bool cross(Point a, Point b, Point c, Point d, double touching);

bool holds(const FlatShape& shape, Point at);
double distance(const FlatShape& one,
                const FlatShape& other);                      ///< mm between their borders
double distance_to_border(const FlatShape& shape, Point at);  ///< mm
bool boxes_meet(const FlatShape& one, const FlatShape& other, double margin);

}  // namespace tactics
