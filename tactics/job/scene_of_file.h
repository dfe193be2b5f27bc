// SPDX-License-Identifier: Apache-2.0
// From any file to a scene, to measure its information.
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
    std::vector<Phrase> notes;  ///< values assumed where none were given: one sentence each, for the user
};

/// As in felt_heights.h: a model and a height file are used directly, and a table of heights as its surface, in 65,536 levels;
/// everything else is drawn as make_pages draws it, without paper around it, as black and white at the dots per inch of its
/// medium. A picture without further wishes, however, becomes its pixels, 256 levels of grey from `heights.low` to
/// `heights.high`. Throws Error: those of felt_heights and read_picture, or if there is nothing to feel.
FileScene scene_of_file(Source source, const std::string& path, const HeightWish& heights, Wishes wishes);

/// The drawing that make_pages makes of a file.
struct FileDrawing {
    LevelGrid grid;             ///< black (1) on white (0)
    double pitch = 0;           ///< mm
    Drawing lines;              ///< as large as the grid
    std::vector<Phrase> notes;  ///< for the user
};

/// For any kind of file: without paper around it, at the dots per inch of its medium. Throws Error: those of make_pages.
FileDrawing drawing_of_file(Source source, const std::string& path, Wishes wishes);

}  // namespace tactics
