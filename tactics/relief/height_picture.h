// SPDX-License-Identifier: Apache-2.0
// Heights as a picture, to be drawn like any other: low is black, high is white.
#pragma once

#include <optional>

#include "tactics/image.h"
#include "tactics/point3.h"
#include "tactics/readers/read.h"
#include "tactics/relief/read_heights.h"

namespace tactics {

/// A model seen straight from above, as finely as a page can show, on a ground around it. The size of the map, 1,000 samples on
/// its longer side, says nothing about the model's. `up` as for read_model. Throws Error(failed) as read_heights does.
HeightFile model_for_picture(Source& source, std::optional<UpAxis> up);

/// Grey, and at most `longest` on its longer side (0: unchanged), by area averaging.
Image picture_of(const HeightFile& file, int longest);

}  // namespace tactics
