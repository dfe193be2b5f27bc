// SPDX-License-Identifier: Apache-2.0
// Splits a page that is larger than a display into the parts that the display shows.
#pragma once

#include <span>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// The parts of that size (mm) of each page, from left to right and from top to bottom; those at the right and bottom may reach
/// beyond the page. Each keeps the whole drawing, shifted, so that dots have the same places as on the whole page.
std::vector<Page> parts_of(std::span<const Page> pages, double width, double height);

}  // namespace tactics
