// SPDX-License-Identifier: Apache-2.0
// Long strokes among ink: links, axes, coasts and other lines that are drawn, and no strokes of letters.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// Of the pixels of a window, 1 where it is.
struct LongStrokes {
    Image strokes;
    Image beside;  ///< with their stairs, where they are neither level nor upright
};

/// `ink` is 1 where ink is, and goes on around the window. Strokes are what is straight for `least` pixels or more, and the
/// shortest ways through ink from one place of the window's border to another.
LongStrokes long_strokes(const Image& ink, const PixelBox& window, int least);

}  // namespace tactics
