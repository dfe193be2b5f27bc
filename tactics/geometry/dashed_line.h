// SPDX-License-Identifier: Apache-2.0
// Dashes of a page as the line that they are felt as.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// A gap longer than so many of its dash is no gap in a line but its end.
inline constexpr double kSameLine = 2;

/// The last stroke of the dashed line whose first dash is that stroke; any other stroke is a line by itself.
std::size_t last_of_line(const Page& page, std::size_t first);

/// The line as if it were whole.
std::vector<Point> whole_line(const Page& page, std::size_t first, std::size_t last);

}  // namespace tactics
