// SPDX-License-Identifier: Apache-2.0
// What was found in a file, as all that follows asks of it: what it is, its shape, its words, and its drawing for a sheet.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tactics/job/job.h"
#include "tactics/job/print_words.h"
#include "tactics/readers/read.h"
#include "tactics/relief/read_heights.h"
#include "tactics/text/note.h"

namespace tactics {

/// How a drawing came about.
struct DrawingWay {
    std::vector<std::string> steps;   ///< the filters with their settings, as fitted to the medium
    std::vector<std::string> chosen;  ///< what they chose from the picture, and why
    std::string chart_json = {};      ///< of a chart, if the wishes ask for it
    bool finer = false;               ///< the picture has more pixels than it was drawn from: on a larger sheet more is drawn
};

/// Adding a kind of source is a function that fills this, and a line in drawable_of.
struct Drawable {
    PictureInfo info;
    Recipe recipe = {};       ///< that draws it; without steps: it is lines already
    std::string reason = {};  ///< why auto chose that; empty: the user named it, or there is none
    PrintWords words = {};
    bool print_is_left = false;  ///< where a page has no room for words in braille: in the lines; else they are left out
    std::string title = {}, title_origin = {};
    std::optional<double> width = {};  ///< mm: it says itself how wide it is in the world
    std::string model_json = {};       ///< of a model that is folded out: what became of its objects
    bool made_for_sheet = false;       ///< its drawing is made by the sheet's rules, another for each, and needs no mending
    /// Width over height of its drawing on that sheet.
    std::function<double(const Sheet& sheet)> aspect = {};
    /// Its drawing for that place, without what stays of `words` in it.
    std::function<Drawing(const Sheet& sheet, const Rect& place, const PrintWords& words, DrawingWay& way)> draw = {};
    /// Its heights, so many mm wide, for formats that have them; empty: they raise its drawing.
    std::function<HeightFile(double width)> heights = {};
};

/// `sheet` is the first that is wanted. `source` must outlive it. `notes` is told what is not as the user might expect. Throws
/// Error.
Drawable drawable_of(Source& source, const Job& job, const Sheet& sheet, Notes& notes);

}  // namespace tactics
