// SPDX-License-Identifier: Apache-2.0
// What stands among the letters of small print and is too pale to be found with them.
#pragma once

#include "tactics/lettering/lettering_line.h"

namespace tactics {

/// A point, or a stem, of less than a pixel that lies across two is paler than half, and is no ink at the level that finds
/// letters best: "0.25" would be read as "025". Adds such ink to the line's letters and marks. It stands among them or right at
/// their ends, apart from all that is dark, and ends there: a line of a grid goes on.
void add_pale_ink(const Image& grey, LetteringLine& line);

/// The line with its letters whole, whose thinnest strokes are paler than half, so that they came apart at the level that finds
/// letters best. Its marks are among the letters then. As it is, if pale ink leads out of it.
LetteringLine joined_by_pale_ink(const Image& grey, const LetteringLine& line);

/// That, if it has far fewer pieces so: print whose thin strokes are all paler than half. Else the line as it is.
LetteringLine whole_if_broken(const Image& grey, LetteringLine line);

}  // namespace tactics
