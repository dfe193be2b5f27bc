// SPDX-License-Identifier: Apache-2.0
// Signs that join letters which stand as far apart as two words.
#pragma once

#include <vector>

#include "tactics/lettering/ink.h"

namespace tactics {

/// Points, commas, minus signs and underscores among boxes, all as their reader sees them. Each question is about two letters,
/// the first at the left.
class SignsBetween {
public:
    explicit SignsBetween(const std::vector<PixelBox>& boxes);

    /// In monospaced print a point has as much room as a letter: "12.5" has a wider gap than two words.
    bool any_point(const PixelBox& a, const PixelBox& b) const;
    /// About as wide as a figure, in the middle of their height, and close to both: "1e-14".
    bool any_minus(const PixelBox& a, const PixelBox& b) const;
    bool any_underscore(const PixelBox& a, const PixelBox& b) const;

private:
    std::vector<PixelBox> points_, bars_;  // in the order of their places
};

}  // namespace tactics
