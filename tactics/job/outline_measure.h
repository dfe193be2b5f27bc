// SPDX-License-Identifier: Apache-2.0
// The outline of a letter in a few numbers, by which it is found again in any size.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "print/letters.h"
#include "tactics/drawing.h"

namespace tactics {

struct OutlineMeasure {
    double area = 0;  ///< in square units; 0: there is no ink
    /// In units, along the line from where its ink begins, as some files do not tell where the letter does, and up from the line:
    /// its width, its bottom and top, where its middle of mass is, how far its mass lies from there along and across (root of the
    /// mean square), how far it slants, an eighth of its rim.
    std::array<double, 9> lengths{};
    std::size_t rings = 0;
    std::size_t corners = 0;  ///< of all rings, curves flattened
};

/// Rings in units that go down, as SVG has them.
OutlineMeasure measure_rings(const std::vector<std::vector<Point>>& rings);

/// In em.
OutlineMeasure measure_letter(const Letter& letter);

/// How far apart they are at most, in em, if so many units of `shape` are one em of `letter`.
double apart_at(const OutlineMeasure& shape, const OutlineMeasure& letter, double em);

}  // namespace tactics
