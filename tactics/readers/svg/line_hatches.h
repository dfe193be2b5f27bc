// SPDX-License-Identifier: Apache-2.0
// Hatches that are drawn line by line in rectangles, as R does.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/readers/svg/found_page.h"

namespace tactics {

struct LineHatch {
    double number = 0;                 ///< from 1 to 2, one for each kind of hatch (FoundLook::fill); 0: no hatch
    std::vector<std::size_t> strokes;  ///< of the page
};

/// Of each of these rectangles. Lines are those of a hatch where they run from side to side, at equal distances, and in another
/// rectangle of the page, too.
std::vector<LineHatch> line_hatches_in(const FoundPage& figure, const std::vector<Box>& rectangles);

}  // namespace tactics
