// SPDX-License-Identifier: Apache-2.0
// A line of our SVG that is drawn as curves, as the points that it was before.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tactics/page.h"
#include "tactics/readers/svg/found_mark.h"

namespace tactics {

/// mm; nearer than this a thing has not been moved: programs write eight digits, and add what a group is moved by.
inline constexpr double kUnmoved = 0.02;

/// The points that it stood for, where they are now, in mm; nothing: it is drawn from point to point, or its curves were changed.
/// `drawn` is what the element draws.
std::optional<std::vector<Point>> course_told(const FoundMark& mark, const PageStroke& drawn);

/// Whether both run through the same places, within `farthest` mm, as fast as each other.
bool run_alike(const std::vector<Point>& a, const std::vector<Point>& b, double farthest);

}  // namespace tactics
