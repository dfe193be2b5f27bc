// SPDX-License-Identifier: Apache-2.0
// Things that people agree on, and how well a thing that was found covers them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tactics/measure/regions.h"

namespace tactics {

struct AgreedObject {
    std::vector<std::uint8_t> mask;      ///< 1 where more than half of those who drew it have it
    std::array<int, 4> box{0, 0, 0, 0};  ///< left, top, right, bottom in pixels, the last two exclusive
    std::array<int, 2> inside{0, 0};     ///< the pixel deepest in it, which is the farthest from its border and from the frame
    double share = 0;                    ///< of the picture
    int people = 0;
};

/// Regions on which at least kAgree annotators agree, with an overlap of 0.7 or more. They cover 2 % to 50 % of the picture and
/// do not touch all four sides, where a box would be meaningless. Regions that most people have come first; a region that
/// overlaps an earlier one by that much is the same.
std::vector<AgreedObject> agreed_objects(std::span<const LabelMap> annotators);

/// Intersection over union of what is not 0; 0 if both are empty. Throws std::logic_error if the masks differ in size.
double overlap_of(std::span<const std::uint8_t> first, std::span<const std::uint8_t> second);

/// The subject by a map of regions: for a point, the region that contains it.
std::vector<std::uint8_t> region_at(const LabelMap& map, std::array<int, 2> pixel);
/// For a box, the regions that are mostly inside it.
std::vector<std::uint8_t> regions_in(const LabelMap& map, const std::array<int, 4>& box);

}  // namespace tactics
