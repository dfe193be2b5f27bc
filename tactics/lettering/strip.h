// SPDX-License-Identifier: Apache-2.0
// A single line of lettering: black on white, upright, as OCR needs it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/lettering/lines.h"

namespace tactics {

enum class Part { words, raised };

/// The line alone, its tallest letter `letter_height` pixels high, nothing around it but white. Gaps between words are
/// widened, as small print has them hardly wider than those between letters.
Image strip_of(const Image& grey, const LetteringLine& line, Part part, int letter_height);
/// The line alone, unchanged and upright, with a pixel around it.
struct BareStrip {
    Image image;
    std::vector<PixelBox> pieces;  ///< where its pieces are in that
    std::vector<int> owner;        ///< of each pixel the piece that it is of or fades from; -1: none
    std::vector<bool> veiled;      ///< pixels of the line's veil, or right beside it; empty: it has none
};
BareStrip bare_strip(const Image& grey, const LetteringLine& line);
/// The smallest and largest number of words by the gaps.
struct WordCount {
    std::size_t least = 1, most = 1;
};
WordCount words_in(const LetteringLine& line);

/// Grey pictures as one TIFF, a page each, not compressed.
std::string tiff_of(const std::vector<Image>& pages);

}  // namespace tactics
