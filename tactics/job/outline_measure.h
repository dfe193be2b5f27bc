// SPDX-License-Identifier: Apache-2.0
// The outline of a letter as a few numbers, by which it is recognised in any size.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "print/letters.h"
#include "tactics/drawing.h"

namespace tactics {

struct OutlineMeasure {
    double area = 0;  ///< in square units; 0: there is no ink
    /// In units, along the baseline from the beginning of its ink (some files do not say where the letter begins), and up from
    /// the baseline: width, bottom and top, centre of mass, spread of the mass along and across (root mean square), slant, and an
    /// eighth of its rim.
    std::array<double, 9> lengths{};
    std::size_t rings = 0;
    std::size_t corners = 0;  ///< of all rings, curves flattened
};

/// From rings whose y points down, as in SVG.
OutlineMeasure measure_rings(const std::vector<std::vector<Point>>& rings);

/// In em.
OutlineMeasure measure_letter(const Letter& letter);

/// The largest difference in em, if that many units of `shape` are one em of `letter`.
double apart_at(const OutlineMeasure& shape, const OutlineMeasure& letter, double em);
/// The same but for how much ink there is: programs make thin strokes as thick as a pixel.
double apart_but_for_ink(const OutlineMeasure& shape, const OutlineMeasure& letter, double em);

}  // namespace tactics
