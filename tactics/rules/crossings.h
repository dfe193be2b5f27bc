// SPDX-License-Identifier: Apache-2.0
// Crossings of lines.
#pragma once

#include <vector>

#include "tactics/rules/page_geometry.h"

namespace tactics {

struct Meeting {
    Point at;
    Station one, other;
    double reach = 0;  ///< two meetings nearer than this are at one place
};

/// Each place where a line continues beyond the ink of another, on both sides of it. `complete`: false if there are too many.
std::vector<Meeting> find_meetings(const PageGeometry& geometry, bool& complete);

}  // namespace tactics
