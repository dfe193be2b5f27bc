// SPDX-License-Identifier: Apache-2.0
// The points of a plot in a picture: small marks of one form and colour that are there several times, alone, over each other, or
// on lines.
#pragma once

#include <cstddef>
#include <vector>

#include "filters/components.h"
#include "tactics/drawing.h"
#include "tactics/geometry/box.h"
#include "tactics/image.h"
#include "tactics/plot.h"

namespace tactics {

/// In pixels; the middle of the first pixel is (0.5, 0.5).
struct InkedMark {
    std::size_t kind = 0;
    Point middle;
    std::vector<Point> hull;  ///< around it, closed
    std::vector<Point> arms;  ///< where lines that it is on leave it
};

struct InkedMarks {
    std::vector<PlotSymbol> symbols;  ///< by kind: all different, if there are enough
    std::vector<double> radii;        ///< by kind, pixels
    std::vector<InkedMark> marks;
    std::vector<Run> rest;  ///< all the ink of what is marks and nothing else
};

/// Marks from `least` to `most` pixels wide and high, of which three at least are alike and by themselves, but for thin lines
/// that they are on. `ink`: ink_on_white of the picture.
InkedMarks inked_marks_in(const Image& picture, const Image& ink, double least, double most);

/// Without those kinds of which most stand in these boxes.
InkedMarks without_print(InkedMarks marks, const std::vector<Box>& print);

/// Painted over with what is beside them; lines that they are on go on.
void take_out(Image& picture, const InkedMarks& marks);

}  // namespace tactics
