// SPDX-License-Identifier: Apache-2.0
// Pieces of ink in a picture: what touches, at one level of grey.
#pragma once

#include <vector>

#include "tactics/image.h"

namespace tactics {

/// A rectangle of pixels: from left and top on, up to but without right and bottom.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
    int width() const { return right - left; }
    int height() const { return bottom - top; }
    bool operator==(const PixelBox&) const = default;
};
PixelBox around(const PixelBox& a, const PixelBox& b);
bool overlap(const PixelBox& a, const PixelBox& b);

/// Pixels of a row that touch each other.
struct InkRun {
    int y = 0, left = 0, right = 0;
};

struct InkPiece {
    PixelBox box;
    std::vector<InkRun> runs;
};

/// Ink is what is darker than `level`, or, if it is light, what is not. Pieces touch along sides or corners; none is wider or
/// higher than `largest` pixels.
std::vector<InkPiece> pieces_of(const Image& grey, int level, bool light, int largest);

}  // namespace tactics
