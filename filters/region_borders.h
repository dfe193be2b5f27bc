// SPDX-License-Identifier: Apache-2.0
// The borders between regions, each once: two neighbours have it in common, however it is smoothed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "filters/region_map.h"
#include "tactics/drawing.h"

namespace tactics {

/// A border between two regions, or of one with the picture's frame, from one place where three meet to the next.
struct Border {
    std::vector<Point> points;  ///< in pixels; smooth
    bool closed = false;        ///< it meets no third region
    std::uint32_t region = 0;   ///< to its right, as it runs
    std::int64_t other = -1;    ///< to its left; -1: the picture ends here
};

/// A region's ring: its borders one after the other, some of them backwards.
struct BorderRing {
    struct Part {
        std::size_t border = 0;
        bool backwards = false;
    };
    std::uint32_t region = 0;
    std::vector<Part> parts;
};

struct RegionBorders {
    std::vector<Border> borders;
    std::vector<BorderRing> rings;

    std::vector<Point> points_of(const BorderRing& ring) const;  ///< the first is not repeated
};

/// Borders keep their course to `tolerance` pixels.
RegionBorders borders_of(const RegionMap& map, double tolerance);

}  // namespace tactics
