// SPDX-License-Identifier: Apache-2.0
// From any file to heights under a finger, with no file between.
#pragma once

#include <optional>
#include <string>

#include "tactics/job/make_pages.h"
#include "tactics/relief/read_heights.h"

namespace tactics {

struct FeltHeights {
    HeightFile file;
    std::optional<Outcome> drawn;  ///< nothing: the file was of heights, or its lightness was taken for them
};

/// A model and a file of heights are what they are, and a picture is when `heights` says how high or wide. All else is drawn as
/// make_pages does it with `wishes`, without paper around it, and its lines are raised: `heights.width` is the drawing's, and
/// `heights.high` that of its lines. "-" is standard input. Throws Error: what read_heights and make_pages say, and nothing to
/// feel.
FeltHeights felt_heights(const std::string& path, const HeightWish& heights, Wishes wishes);

}  // namespace tactics
