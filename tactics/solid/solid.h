// SPDX-License-Identifier: Apache-2.0
// A solid as a hand knows it: plane patches and the seams between them, however the file divides them into polygons.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/welded.h"

namespace tactics {

/// A connected part of a surface in one plane.
struct Patch {
    Point3 normal;    ///< of length 1, outwards
    double area = 0;  ///< mm2
    /// Counter-clockwise seen from outside, holes clockwise; the largest first.
    /// Only corners, no points on straight sides; over 1,000 of a ring are made fewer, within a thousandth of its extent.
    std::vector<std::vector<Point3>> rings;
};

/// A line where two patches meet: a straight side of both, or a part of one.
struct Seam {
    std::uint32_t one = 0, other = 0;  ///< places in Solid::patches
    Point3 from, to;                   ///< as `one` goes round it
    double bend = 0;                   ///< radians by which the surface turns there: > 0 at a
                                       ///< ridge, < 0 in a groove
};

struct Solid {
    std::vector<Patch> patches;
    std::vector<Seam> seams;
    bool closed = false;  ///< no side of a patch is without a neighbour
};

/// One shell of a surface whose faces look outwards. Patches are in the order
/// of their size, the largest first, and equal ones by where they are, so that
/// the order in which a file has its faces makes no difference.
Solid solid_of(const WeldedSurface& surface, const std::vector<std::uint32_t>& shell);

/// The place, which lies in their plane, is within the rings (even-odd rule).
bool is_over(const Point3& at, const Point3& normal, const std::vector<std::vector<Point3>>& rings);
double length_of(const Seam& seam);    ///< mm
Point3 middle_of(const Patch& patch);  ///< of its corners

}  // namespace tactics
