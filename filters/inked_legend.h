// SPDX-License-Identifier: Apache-2.0
// The legend of a picture: words with a sample beside them, of a curve or a surface that is painted like it. What only a colour
// says nobody feels, so such words go to the thing itself, as a transcriber sets them.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// Words of the picture that run level, in pixels.
struct LegendWords {
    PixelBox box;
    double height = 0;  ///< of their letters
};

struct LegendEntry {
    std::size_t words = 0;  ///< their number
    PixelBox sample;
    Point at;  ///< on what looks like it, in pixels, where all else is farthest
};

/// Of a picture whose words are painted over. Empty unless at least two words have samples in a row or a column. An entry is left
/// out if its sample looks like another one, or if nothing else is painted so. A line may differ by its dashes only; one that is
/// whole, and as black or grey as axes may be, counts beside dashed ones, if only one curve is so.
std::vector<LegendEntry> legend_in(const Image& picture, const std::vector<LegendWords>& words);

}  // namespace tactics
