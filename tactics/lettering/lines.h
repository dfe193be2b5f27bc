// SPDX-License-Identifier: Apache-2.0
// Lines of lettering in a picture, found by how letters stand: alike in size, side by side.
#pragma once

#include <vector>

#include "tactics/lettering/ink.h"

namespace tactics {

/// Letters that make one line of words. It runs to the right, or upwards, as the names of upright axes do.
struct LetteringLine {
    bool upwards = false;
    bool light = false;             ///< on a darker ground
    int level = 0;                  ///< of grey, between letters and ground
    PixelBox box;                   ///< of all its ink
    int letter_height = 0;          ///< of the tallest letter, across the line
    std::vector<InkPiece> letters;  ///< along the line
    std::vector<InkPiece> marks;    ///< dots, minus signs and other small ink among them
    std::vector<InkPiece> raised;   ///< smaller letters above the line at its end: an exponent
};

/// No line has ink in common with another. Stray ink that is as large as a letter comes as lines of one letter. Some of these may
/// be parts of a line that climbs and has one or two letters, as numbers at an upright axis do: `climbing` gets such lines.
/// `low` gets lines that have no letter as tall as others of small print, the likelier ones first; these may have ink in common
/// with each other.
std::vector<LetteringLine> find_lettering(const Image& grey, std::vector<LetteringLine>* climbing = nullptr,
                                          std::vector<LetteringLine>* low = nullptr);

}  // namespace tactics
