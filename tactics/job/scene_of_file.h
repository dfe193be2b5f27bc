// SPDX-License-Identifier: Apache-2.0
// From any file to a scene whose information is measured.
#pragma once

#include <string>
#include <vector>

#include "tactics/information/scene.h"
#include "tactics/job/wishes.h"
#include "tactics/relief/read_heights.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct FileScene {
    MeasuredScene scene;
    std::string format;         ///< "JPEG", "16-bit PNG", "drawing", ...
    std::vector<Phrase> notes;  ///< what was taken where nothing was told: a sentence each, for the user
};

/// As felt_heights.h has it: a model and a file of heights are what they are, and a table of heights is their surface, in 65,536
/// levels; all else is drawn as make_pages draws it, without paper around it, as black and white at the dots per inch of its
/// medium. But a picture of which nothing else is wished is its pixels, 256 levels of grey from `heights.low` to `heights.high`.
/// Throws Error: what felt_heights and read_picture say, and nothing to be felt.
FileScene scene_of_file(Source source, const std::string& path, const HeightWish& heights, Wishes wishes);

/// What make_pages draws of a file.
struct FileDrawing {
    LevelGrid grid;             ///< black (1) on white (0)
    double pitch = 0;           ///< mm
    Drawing lines;              ///< as large as the grid
    std::vector<Phrase> notes;  ///< for the user
};

/// Of any file, whatever it holds: without paper around it, at the dots per inch of its medium. Throws Error: what make_pages
/// says.
FileDrawing drawing_of_file(Source source, const std::string& path, Wishes wishes);

}  // namespace tactics
