// SPDX-License-Identifier: Apache-2.0
// What of a drawing lies within a rectangle.
#pragma once

#include <optional>
#include <vector>

#include "tactics/geometry/clipped.h"
#include "tactics/page.h"
#include "tactics/readers/svg/svg_path.h"

namespace tactics {

/// The rectangle around points, as they come.
struct Extent {
    Rect box;
    std::size_t points = 0;
    void add(Point p);
};

void add_all(Extent& extent, const std::vector<Subpath>& subpaths);

/// What both rectangles share; one of no size if they share nothing.
Rect common_of(const Rect& rect, Point corner, Point opposite);
bool lies_in(const std::vector<Point>& points, const Rect& rect);

bool is_within(const Subpath& subpath, double farthest);  ///< of both coordinates; false for what is no number

/// Adds what of a line lies in the rectangle, if there is one.
void add_clipped(Page& page, PageStroke stroke, const std::optional<Rect>& clip);

}  // namespace tactics
