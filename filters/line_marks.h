// SPDX-License-Identifier: Apache-2.0
// Marks made of lines that stand on lines, so that no piece of ink shows what they look like: open circles, squares, diamonds and
// triangles, upright and slanting crosses.
#pragma once

#include <vector>

#include "filters/mark_kinds.h"

namespace tactics {

/// Kinds of which there are at least five of one size and colour, not in a row that is level or upright, each left by one or two
/// lines. `ink` as for mark_kinds_in; `least`, `most`: pixels across.
std::vector<MarkKind> kinds_on_lines(const Image& picture, const Image& ink, double least, double most);

}  // namespace tactics
