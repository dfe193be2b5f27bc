// SPDX-License-Identifier: Apache-2.0
// Thin straight strokes of ink, level or upright, whatever they stand on.
#pragma once

#include <array>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// In pixels: [begin, end) along it, [low, high) across.
struct ThinStroke {
    int begin = 0, end = 0, low = 0, high = 0;
    int length() const { return end - begin; }
    double middle() const { return (low + high) / 2.0; }
};

/// Level ones are found as upright ones of the picture turned over its diagonal.
struct ThinStrokes {
    Image grey, turned;  ///< the picture, and so turned
    std::vector<ThinStroke> upright, level;
};

inline constexpr double kWidestStroke = 1.2;  ///< mm on the page; a setting

/// All strokes of a picture, which has its size in mm, that are at least so long, thin and clearly darker than what is
/// on both sides of them. Lines that they cross do not part them. None if there are thousands, as in a hatch or a text.
ThinStrokes thin_strokes_in(const Image& picture, double shortest_mm);

/// So many pixels around a stroke are paler than it, and not the ground.
inline constexpr int kStrokeHalo = 2;

/// Gives each pixel of the stroke and its halo the colour of what is beside it, on its own side.
void take_out(Image& picture, const ThinStroke& stroke, bool level);

std::array<Point, 2> ends_of(const ThinStroke& stroke, bool level);

/// A pixel of a grey picture, or the nearest to it.
int grey_at(const Image& grey, int x, int y);

}  // namespace tactics
