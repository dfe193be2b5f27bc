// SPDX-License-Identifier: Apache-2.0
// Which lines of braille on a page are whose name.
#pragma once

#include <vector>

#include "tactics/page.h"

namespace tactics {

/// For each line of braille the name in whose place it begins, the first of the page's names if several have it; nullptr: it is
/// nobody's, such as a title's.
std::vector<const PageName*> names_of_lines(const Page& page);

}  // namespace tactics
