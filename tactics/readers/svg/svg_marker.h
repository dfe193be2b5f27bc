// SPDX-License-Identifier: Apache-2.0
// Markers of SVG: what stands at the ends of lines, above all arrow heads.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/page.h"
#include "tactics/readers/svg/svg_path.h"
#include "tactics/readers/svg/transform.h"
#include "tactics/readers/xml.h"

namespace tactics {

/// Of the shapes of SVG those whose ends can have markers (SVG 1.1, 11.6.2).
bool takes_markers(const Element& element);

/// The end of a line in mm, and where the line goes there.
struct LineEnd {
    Point at;
    double angle = 0;  ///< radians
    bool start = false;
};

/// The beginning and the end of a path. Nothing: it has neither.
std::optional<std::pair<LineEnd, LineEnd>> ends_of(const std::vector<Subpath>& subpaths);

/// What puts a marker's content to the end of a line of that width in mm, `scale` being mm for a px of the line.
Transform marker_place(const Element& marker, const LineEnd& end, double width, double scale);

/// A small shape that is no rectangle, such as an arrow head, a note or a mark of a plot: filled dark, it stays full. In mm of a
/// figure.
bool is_sign(const std::vector<Subpath>& subpaths);

/// Corners of an arrow head: a triangle, or one with a barb, a corner that turns the other way.
bool is_head(const std::vector<Point>& ring);

/// What was drawn for a marker, from these strokes and areas on: an arrow head if it is one shape of three or four corners,
/// else a point symbol. A line around a surface is of the same shape.
void tell_marker(Page& page, std::size_t strokes, std::size_t areas);

}  // namespace tactics
