// SPDX-License-Identifier: Apache-2.0
// Pieces of ink in a picture: what touches, at one level of grey.
#pragma once

#include <algorithm>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// Pixels of a row that touch each other.
struct InkRun {
    int y = 0, left = 0, right = 0;
};

/// Pixels that letters are high: below they cannot be told apart; above, the ink is a drawn thing.
inline constexpr int kLeastInkHeight = 5, kMostInkHeight = 100;

struct InkPiece {
    PixelBox box;
    std::vector<InkRun> runs;
};

/// Of its box.
double share_of_ink(const InkPiece& piece);

/// From a part of a picture back to the picture.
void move_piece(InkPiece& piece, int right, int down);
/// It touches no side of that part.
bool ends_within(const InkPiece& piece, const Image& part);

/// Between two boxes side by side; below zero if one is above the other.
inline int gap_along(const PixelBox& one, const PixelBox& other) {
    return std::max(one.left, other.left) - std::min(one.right, other.right);
}

/// Ink is every pixel darker than `level`, or, for light ink, every other pixel. Pieces touch along sides or corners; none is
/// wider or higher than `largest` pixels.
std::vector<InkPiece> pieces_of(const Image& grey, int level, bool light, int largest);

}  // namespace tactics
