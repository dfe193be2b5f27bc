// SPDX-License-Identifier: Apache-2.0
// Lines and areas of a page as paths of SVG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// Hundredths of a millimetre as millimetres, as short as can be: 1.5, .05, -3.
void append_mm(std::string& text, double mm);
/// ` name="1.5"`
void append_attribute(std::string& text, std::string_view name, double mm);

/// Straight from point to point, each from the one before it on the grid of whole steps: short, and no error adds up.
void append_path(std::string& text, const std::vector<Point>& points, bool closed);

/// The attributes of a path that say how such a line runs, with blanks before them: `d`, and, where it is drawn as curves,
/// what it was before.
std::string course_attributes(const PageStroke& stroke);

}  // namespace tactics
