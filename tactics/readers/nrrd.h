// SPDX-License-Identifier: Apache-2.0
// Voxels in NRRD files ("nearly raw raster data", https://teem.sourceforge.net/nrrd/format.html), as ITK, 3D Slicer, ParaView,
// pynrrd and others write them: numbers, or forces, on a lattice.
#pragma once

#include <string>
#include <vector>

#include "tactics/readers/read.h"

namespace tactics {

inline constexpr long long kMostVoxels = 8'000'000;  ///< numbers: a vector counts as three

struct Voxels {
    int columns = 0, rows = 0, slices = 0;
    int components = 1;  ///< 1: a number each; 3: a vector each
    /// How many whole numbers the type of the file has, 256 or 65536; 0: it has others, or fractions.
    int levels = 0;
    double lowest = 0;           ///< of the type, if it has levels
    std::vector<double> values;  ///< row by row, slice by slice; of a vector x, y, z. Below 1e100.
};

/// By its first bytes. Rewinds the source.
bool is_nrrd(Source& source);

/// Of an attached file, raw, as text, or gzip. Throws Error(failed): cut short, not three-dimensional, over kMostVoxels, data in
/// another file, a type or an encoding that is not read, a value that is no number or too large.
Voxels read_nrrd(Source& source);

}  // namespace tactics
