// SPDX-License-Identifier: Apache-2.0
// A page that is larger than a display, as what the display shows of it at a time.
#pragma once

#include <span>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// Of each page the parts of that size (mm), from left to right and from the top to the bottom; those at the right and the lower
/// side may reach beyond the page. Each keeps all of the drawing, moved, so that dots stand where they stand on the whole.
std::vector<Page> parts_of(std::span<const Page> pages, double width, double height);

}  // namespace tactics
