// SPDX-License-Identifier: Apache-2.0
// STL models, binary and text: triangles without a unit, which are taken as mm.
#pragma once

#include <array>
#include <cstdio>
#include <functional>
#include <string>

#include "tactics/readers/read.h"

namespace tactics {

struct Triangle {
    std::array<std::array<double, 3>, 3> corners;  ///< finite; normals are not read
};

/// By its size (binary), its first word (text) or the end of its name.
bool is_stl(Source& source);

/// Visits all triangles in the order of the file, without storing them; the file may be read again. Throws Error(failed) if it is
/// truncated, has an invalid number, is no valid STL, or has no triangle.
void each_triangle(Source& source, const std::function<void(const Triangle&)>& take);

}  // namespace tactics
