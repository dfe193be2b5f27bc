// SPDX-License-Identifier: Apache-2.0
// Which braille lines on a page belong to which name.
#pragma once

#include <vector>

#include "tactics/page.h"

namespace tactics {

/// For each braille line, the first of the page's names in whose box it begins; nullptr: none, as for a title.
std::vector<const PageName*> names_of_lines(const Page& page);

}  // namespace tactics
