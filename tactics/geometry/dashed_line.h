// SPDX-License-Identifier: Apache-2.0
// Joins the dashes of a page into the line that they form.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// A gap longer than this many dashes is the end of the line.
inline constexpr double kSameLine = 2;

/// Whether a hand goes over from the end of a dash to the beginning of the next one: in the direction in which the one ends and
/// the other begins, and not to a line beside it. Each has two points at least.
bool goes_on(std::span<const Point> dash, std::span<const Point> next);

/// The last stroke of the dashed line whose first dash is that stroke; any other stroke is a separate line.
std::size_t last_of_line(const Page& page, std::size_t first);

/// The line as if it were whole.
std::vector<Point> whole_line(const Page& page, std::size_t first, std::size_t last);

}  // namespace tactics
