// SPDX-License-Identifier: Apache-2.0
// What stands right beyond the ends of a line of print, or among its letters, and is none of it.
#pragma once

#include "tactics/image.h"
#include "tactics/lettering/lines.h"

namespace tactics {

/// Nearer to an end than that share of the height of its letters there is what may be one of them: a letter that touches what is
/// drawn and is part of that now, or one that the picture cuts off; or no farther off than words are, such a letter sticks out of
/// a line that passes: the 5 of "5 kg" at the side of a box.
bool is_cut(const Image& grey, const LetteringLine& line, double near);

/// Something is where a sign of degrees would stand behind its last figure.
bool may_hide_sign(const Image& grey, const LetteringLine& line);

/// Something stands among its letters or below them that is none of them and ends there, such as the low line of "X_1", which is
/// thin, and paler than they are.
bool has_strange_ink(const Image& grey, const LetteringLine& line);

}  // namespace tactics
