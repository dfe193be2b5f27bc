// SPDX-License-Identifier: Apache-2.0
// From any file to heights under a finger, with no file between.
#pragma once

#include <optional>
#include <string>

#include "tactics/information/channel.h"
#include "tactics/job/make_pages.h"
#include "tactics/relief/read_heights.h"

namespace tactics {

struct FeltHeights {
    HeightFile file;
    std::optional<Outcome> drawn;  ///< nothing: the file was of heights, or its lightness was taken for them
};

/// `source` is that of the path, open already: a model and a file of heights are what they are, a table of heights over x and y
/// is the surface that they are, and a picture is heights when `heights` says how high or wide. All else is drawn as make_pages
/// does it with `wishes`, without paper around it, and its lines are raised: `heights.width` is the drawing's, and `heights.high`
/// that of its lines; so is a table of heights for which `wishes` ask for a way. Throws Error: what read_heights, plot_of and
/// make_pages say, and nothing to feel.
FeltHeights felt_heights(Source source, const std::string& path, const HeightWish& heights, Wishes wishes);

/// The heights transformed so that the medium loses least of them (information/least_loss.h), and a note of what was done and
/// why. Throws Error(failed): one of them is not a number, or all are one height. `name` is the file's, for messages.
void fit_heights(HeightFile& file, const MediumChannel& channel, const std::string& name);

}  // namespace tactics
