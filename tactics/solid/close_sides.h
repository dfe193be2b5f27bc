// SPDX-License-Identifier: Apache-2.0
// Sides that a finger could not tell from each other: those of a board's edge, of a groove, of a narrow strip.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/solid/joined_sides.h"

namespace tactics {

/// Of two nearly parallel sides that lie beside each other closer than `apart`, mm, but farther than `touching`, for three times
/// that length at least, the shorter moves onto the longer, and what ends on it goes along: a narrow strip becomes one line, what
/// is beside it stays whole and grows by its width. What others are on already stays, if it may, and then the longer one moves.
/// What is left is merged. Returns the number of sides that were moved.
std::size_t unite_close(std::vector<DrawnSide>& sides, double touching, double apart);

}  // namespace tactics
