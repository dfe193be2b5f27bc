// SPDX-License-Identifier: Apache-2.0
// The basic shapes of SVG with their attributes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tactics/page.h"
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
/// Throws Error(failed) at the element's line; a path with a fault is drawn up to it and counted, if `broken` is given.
bool draw_outline(const Element& element, const SvgLengths& lengths, Pen& pen, std::size_t* broken);

/// Where the x, y, width and height of a rectangle or picture come to lie, in mm. Nothing: it is turned or skewed.
std::optional<Rect> upright_box(const Element& element, const SvgLengths& lengths, const Transform& transform);

/// What a clipPath leaves of the page, in mm, if it is an upright rectangle.
std::optional<Rect> clip_rectangle(const Element& clip, const SvgLengths& lengths, const Transform& transform);

}  // namespace tactics
