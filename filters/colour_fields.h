// SPDX-License-Identifier: Apache-2.0
// Fields of colours that stand for values: heat maps, filled contours, pictures with a colour bar.
#pragma once

#include <optional>
#include <vector>

#include "filters/colour_scale.h"
#include "tactics/image.h"

namespace tactics {

struct ColourBar {
    PixelBox box;
    bool upright = true;
};

struct ColourField {
    PixelBox box;  ///< within its frame
    ColourScale scale;
    std::optional<ColourBar> bar;  ///< that says what its colours mean; fields may share one
};

/// Rectangles on a plain ground that are filled with the colours of one scale, from top to bottom. Colours are looked for in bars
/// first, narrow strips on the same ground; a field whose colours no bar has must show its scale itself.
std::vector<ColourField> colour_fields_in(const Image& picture);

/// The picture in three channels.
cv::Mat three_channels(const Image& picture);

}  // namespace tactics
