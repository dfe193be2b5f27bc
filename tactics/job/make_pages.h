// SPDX-License-Identifier: Apache-2.0
// The one verb of the library: a picture becomes its pages.
#pragma once

#include <functional>
#include <set>
#include <shared_mutex>
#include <string>
#include <vector>

#include "tactics/artwork.h"
#include "tactics/error.h"
#include "tactics/job/broken_rules.h"
#include "tactics/job/job.h"
#include "tactics/job/mending.h"
#include "tactics/layout/place.h"
#include "tactics/readers/read.h"
#include "tactics/text/note.h"

namespace tactics {

/// Files are written while this is held shared; who holds it alone knows that nothing is half written.
using WriteGate = std::shared_timed_mutex;

/// A file that was written.
struct Made {
    Output output;
    std::size_t bytes = 0;
    std::size_t layout = 0;  ///< index into Outcome::layouts
    std::size_t page = 1;    ///< the first that is in it
    std::size_t pages = 1;   ///< how many are in it
};

/// A drawing on a sheet; several files may share it.
struct Layout {
    Sheet sheet;
    Place place;
    std::size_t pages = 1;  ///< the drawing's and those of its key
    std::size_t strokes = 0;
    double stroke_length = 0;        ///< mm
    std::size_t areas = 0;           ///< black
    std::size_t textured = 0;        ///< filled with a pattern
    bool has_picture = false;        ///< dots rather than lines
    std::size_t text_lines = 0;      ///< of braille, on pages that are text
    bool empty = false;              ///< nothing to feel but the title
    std::vector<std::string> names;  ///< in reading order
    MendingTold mended;              ///< what was changed for the rules
    std::vector<BrokenRule> broken;  ///< if the wishes ask for it (check_rules)
    std::vector<Page> shown;         ///< with the whole drawing, then those of its key; only for an output without a path
};

/// Pages that go into a file with those of other pictures.
struct BoundPages {
    std::size_t output = 0;  ///< which of the item's
    std::vector<Page> pages;
};

/// All that is known about one picture and what became of it.
struct Outcome {
    std::string input;
    int pdf_page = 0;  ///< of a PDF of which several pages are made
    PictureInfo picture;
    std::string recipe;               ///< its name
    std::string reason;               ///< why auto chose it; empty if the user named it
    bool keeps_some = false;          ///< of what it finds, by a budget of line; wishes can give it more
    std::vector<std::string> steps;   ///< its filters with their settings, as fitted to the medium of the first layout
    std::vector<std::string> chosen;  ///< what those filters chose from the picture there, and why
    std::vector<Layout> layouts;
    std::vector<Made> made;
    std::vector<BoundPages> to_bind;  ///< of outputs that are bound: nothing of these is written yet
    std::vector<ToldWords> words;     ///< print in the picture
    std::string model_json;           ///< of a model that is folded out: what became of its objects (model_drawing.h)
    std::string chart_json;           ///< of a chart on its first layout, if the wishes ask for it (chart_json.h)
    Notes notes;                      ///< for the user
    /// Files beside the outputs that are named like a further page, and no page of this picture: of an earlier run, or a
    /// person's own, so they are told and left.
    std::vector<std::string> left_over;
    bool up_to_date = false;             ///< --update found nothing to do
    std::vector<Phrase> made_anew = {};  ///< why --update made pages that were there
    double seconds = 0;
    Phrase error;                 ///< empty: done
    Fault fault = Fault::failed;  ///< only with an error
};

/// "photo.jpg", "standard input", "book.pdf page 3": for messages.
std::string name_of_input(const Outcome& outcome);

/// Where a job is.
enum class JobStep { reading, drawing, laying_out, writing };

/// Who looks on while pages are made.
struct Watch {
    /// Called before each step, by the thread that makes the pages; false: the job is given up, and nothing is written.
    std::function<bool(JobStep step)> goes_on = {};
    WriteGate* gate = nullptr;                     ///< nullptr: nobody wants to know that nothing is half written
    const std::set<std::string>* taken = nullptr;  ///< taken_by (page_files.h) the other items of a batch; nullptr: there is none
};

/// Makes the pages of a picture and writes them, all or none. Never throws: what goes wrong stands in the outcome. Safe from any
/// thread. The picture is read once for each size in pixels that the layouts need, so that the bytes of a file do not depend on
/// what other files are made with it.
Outcome make_pages(const Job& job, const Watch& watch = {});

/// The same for a picture that is open already.
Outcome make_pages(Source source, const Job& job, const Watch& watch = {});

}  // namespace tactics
