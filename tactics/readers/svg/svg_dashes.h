// SPDX-License-Identifier: Apache-2.0
// Dashed lines of SVG as the pieces that are seen.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tactics/readers/svg/svg_path.h"

namespace tactics {

/// Lengths in mm: a dash, a gap, a dash ... an even number of them; empty: a whole line.
struct Dashes {
    std::vector<double> lengths;
    double offset = 0;  ///< of the first dash, how much lies before the line's beginning
};

/// stroke-dasharray and stroke-dashoffset; `whole` is what percentages are of, in px, `scale` makes mm of px.
Dashes parse_dashes(std::string_view array, std::string_view offset, double whole, double scale);

/// Nothing if it were more than `most` pieces: nobody feels them one by one.
std::optional<std::vector<Subpath>> cut_into_dashes(const Subpath& line, const Dashes& dashes, std::size_t most);

}  // namespace tactics
