// SPDX-License-Identifier: Apache-2.0
// The contents of any file, in one form for all later steps: what it is, its shape, its words, and its drawing for a sheet.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tactics/job/best_detail.h"
#include "tactics/job/job.h"
#include "tactics/job/print_words.h"
#include "tactics/job/trimmed.h"
#include "tactics/readers/read.h"
#include "tactics/relief/read_heights.h"
#include "tactics/text/note.h"

namespace tactics {

/// How a drawing was made.
struct DrawingWay {
    std::vector<std::string> steps;           ///< the filters with their settings, as fitted to the medium
    std::vector<ChosenSetting> chosen;        ///< what they chose for the picture, and why
    std::string chart_json = {};              ///< of a chart, if requested
    std::optional<DetailChoice> detail = {};  ///< if the wishes leave it to the medium
    std::vector<Phrase> told = {};            ///< of parts that are drawn otherwise than in the picture
    bool finer = false;                       ///< the picture has more pixels than were used: a larger sheet shows more
};

/// To add a kind of source, write a function that fills this, and add a line to drawable_of.
struct Drawable {
    PictureInfo info;
    Recipe recipe = {};  ///< recipe that draws it; no steps: it consists of lines already
    Phrase reason = {};  ///< why auto chose it; empty: the user named it, or there is none
    PrintWords words = {};
    bool print_is_left = false;  ///< what happens to words that have no room in braille: left in the lines; else left out
    std::string title = {}, title_origin = {};
    std::optional<double> width = {};      ///< real width from the file, mm
    std::string model_json = {};           ///< of a folded-out model: what was done with its objects
    Rect inked = kWhole;                   ///< what trim() would leave of it, in shares of the picture's sides
    Rect part = kWhole;                    ///< what is drawn of it, likewise
    bool made_for_sheet = false;           ///< it is drawn for each sheet by the sheet's rules, and needs no mending
    std::shared_ptr<const Page> own = {};  ///< a page that we wrote, as it was (own_pages.h)
    /// Width / height of its drawing on that sheet.
    std::function<double(const Sheet& sheet)> aspect = {};
    /// The drawing of that part of it for that place, without the print that `words` removes.
    std::function<Drawing(const Sheet& sheet, const Rect& place, const Rect& part, const PrintWords& words, DrawingWay& way)>
        draw = {};
    /// Its heights, that many mm wide, for height formats; empty: such formats raise its drawing.
    std::function<HeightFile(double width)> heights = {};
};

/// `sheet` is the first one needed. `source` must outlive it. `notes` receives anything that the user might not expect. Throws
/// Error.
Drawable drawable_of(Source& source, const Job& job, const Sheet& sheet, Notes& notes);

/// Unless the user measures the whole picture, or on the drawing.
bool may_trim(const Job& job, const Sheet& sheet);
/// From then on it draws its inked part only.
void trim(Drawable& drawable);

}  // namespace tactics
