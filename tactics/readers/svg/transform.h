// SPDX-License-Identifier: Apache-2.0
// Plane transforms, as SVG writes them.
#pragma once

#include <string_view>

#include "tactics/drawing.h"

namespace tactics {

/// x' = a x + c y + e, y' = b x + d y + f
struct Transform {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    Point operator()(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    /// What a width becomes: the mean of both ways, if they differ.
    double scale() const { return std::sqrt(std::abs(a * d - b * c)); }
    bool turns_or_skews() const { return b != 0 || c != 0; }
    /// Widths do not become the same in all directions.
    bool stretches() const;
};

/// First `inner`, then `outer`.
Transform operator*(const Transform& outer, const Transform& inner);

/// "translate(3 4) rotate(45)". Gives false if it is not spelled so.
bool parse_transform(std::string_view text, Transform& transform);

/// What puts the box of a view (left, top, width, height) into a place of that size at (0, 0), as preserveAspectRatio says.
Transform fit_view(const double view[4], double width, double height, std::string_view preserve);

}  // namespace tactics
