// SPDX-License-Identifier: Apache-2.0
// A piece of ink that may be a dash.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "filters/components.h"
#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

using InkHue = std::array<double, 3>;  ///< what the ink takes from white, of length 1

struct InkedDash {
    Point ends[2];  ///< pixels, of its middle line
    double width = 0;
    std::uint32_t piece = 0;  ///< of the picture's
    InkHue hue{};
    double whole_length() const { return length() + width; }
    Point middle() const { return {(ends[0].x + ends[1].x) / 2, (ends[0].y + ends[1].y) / 2}; }
    double length() const { return distance(ends[0], ends[1]); }
};

/// Along its main axis (of the second moments), if it is thin across it. The limits are in pixels.
std::optional<InkedDash> inked_dash(const std::vector<const Run*>& runs, double longest, double widest);

/// Soft borders are pale, but of the same hue.
InkHue hue_of(const Image& picture, const std::vector<const Run*>& runs);

bool have_one_hue(const InkedDash& a, const InkedDash& b);

}  // namespace tactics
