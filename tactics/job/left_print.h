// SPDX-License-Identifier: Apache-2.0
// Print that nobody read and that stays in the picture: where it is, and whether it is drawn.
#pragma once

#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/job/print_words.h"

namespace tactics {

/// Where it is, in pixels of that part (in shares of its sides) of the picture.
std::vector<Box> left_print_in(const PrintWords& words, const Image& picture, const Rect& part);

/// A recipe for surfaces leaves out what is as small as a letter: says how many of these places, in pixels of `mm` each, have
/// nothing of the drawing.
void tell_lost_print(const std::vector<Box>& print, double mm, const Drawing& drawing, std::vector<Phrase>& told);

}  // namespace tactics
