// SPDX-License-Identifier: Apache-2.0
// Lines of lettering in a picture, found by how letters stand: alike in size, side by side.
#pragma once

#include <vector>

#include "tactics/lettering/lettering_line.h"

namespace tactics {

/// No line has ink in common with another. Stray ink that is as large as a letter comes as lines of one letter. Some of these may
/// be parts of a line that climbs and has one or two letters, as numbers at an upright axis do: `climbing` gets such lines.
/// `low` gets lines that have no letter as tall as others of small print, the likelier ones first; these may have ink in common
/// with each other.
std::vector<LetteringLine> find_lettering(const Image& grey, std::vector<LetteringLine>* climbing = nullptr,
                                          std::vector<LetteringLine>* low = nullptr);

}  // namespace tactics
