// SPDX-License-Identifier: Apache-2.0
// The basic shapes of SVG with their attributes.
#pragma once

#include <string>
#include <string_view>

#include "tactics/readers/svg/svg_path.h"
#include "tactics/readers/xml.h"

namespace tactics {

/// Lengths of a file: percentages are of its outermost view.
struct SvgLengths {
    const std::string& file;
    double width = 0, height = 0;  ///< of that view, px

    /// Throw Error(failed) at the element's line.
    double across(const Element& element, std::string_view name, double fallback = 0) const;
    double down(const Element& element, std::string_view name, double fallback = 0) const;
    double whole() const;  ///< what a percentage is of that is neither across nor down
};

/// The outline of a path, line, polyline, polygon, rectangle, circle or ellipse. False: it is none of these, or has no size.
/// Throws Error(failed) at the element's line.
bool draw_outline(const Element& element, const SvgLengths& lengths, Pen& pen);

}  // namespace tactics
