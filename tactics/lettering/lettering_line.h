// SPDX-License-Identifier: Apache-2.0
// A line of lettering, as ink.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "tactics/image.h"
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
    std::vector<InkRun> veil = {};  ///< ink of what is drawn, which touches letters and may hide parts of them
};

/// Ink of that line, or as dark, is at this pixel. Outside of the picture there is none.
inline bool is_ink(const Image& grey, const LetteringLine& line, int x, int y) {
    return x >= 0 && y >= 0 && x < grey.width && y < grey.height && (grey.row(y)[x] < line.level) != line.light;
}

/// This pixel is of the line's veil, or fades from it.
inline bool is_veiled(const LetteringLine& line, int x, int y) {
    return std::any_of(line.veil.begin(), line.veil.end(),
                       [&](const InkRun& run) { return std::abs(run.y - y) <= 1 && x >= run.left - 1 && x <= run.right; });
}

}  // namespace tactics
