// SPDX-License-Identifier: Apache-2.0
// From any file to heights under a finger, without an intermediate file.
#pragma once

#include <optional>
#include <string>

#include "tactics/information/channel.h"
#include "tactics/job/make_pages.h"
#include "tactics/relief/read_heights.h"

namespace tactics {

struct FeltHeights {
    HeightFile file;
    std::optional<Outcome> drawn;  ///< nothing: the file held heights, or its lightness was used as heights
};

/// `source` is the opened file of the path. A model and a height file are used directly, a table of heights over x and y becomes
/// its surface, and a picture becomes heights if `heights` gives its height or width. Everything else, and a table of heights for
/// which `wishes` choose a view, is drawn as make_pages does with `wishes`, without paper around it, and its lines are raised:
/// `heights.width` is the width of the drawing, `heights.high` the height of its lines. Throws Error: those of read_heights,
/// plot_of and make_pages, or if there is nothing to feel.
FeltHeights felt_heights(Source source, const std::string& path, const HeightWish& heights, Wishes wishes);

/// Transforms the heights so that the medium loses the least of them (information/least_loss.h), with a note on what was done and
/// why. Throws Error(failed) if one of them is not a number, or all are equal. `name` is the file name for messages.
void fit_heights(HeightFile& file, const MediumChannel& channel, const std::string& name);

}  // namespace tactics
