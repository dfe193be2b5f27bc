// SPDX-License-Identifier: Apache-2.0
// Ticks of an upright axis right behind its numbers or names, where they look like dashes.
#pragma once

#include <vector>

#include "tactics/lettering/lettering_line.h"

namespace tactics {

/// Lines that end with a level stroke at their middle height lose it if another one has such a stroke in the same columns.
void drop_tick_ends(std::vector<LetteringLine>& lines);

}  // namespace tactics
