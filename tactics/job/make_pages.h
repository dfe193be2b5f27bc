// SPDX-License-Identifier: Apache-2.0
// The main function of the library: makes the pages of a picture.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <shared_mutex>
#include <string>
#include <vector>

#include "tactics/artwork.h"
#include "tactics/error.h"
#include "tactics/job/best_detail.h"
#include "tactics/job/broken_rules.h"
#include "tactics/job/job.h"
#include "tactics/job/mending.h"
#include "tactics/layout/place.h"
#include "tactics/readers/read.h"
#include "tactics/text/note.h"

namespace tactics {

/// Files are written while this lock is held shared; an exclusive holder knows that no file is half written.
using WriteGate = std::shared_timed_mutex;

/// A file that was written.
struct Made {
    Output output;
    std::size_t bytes = 0;
    std::size_t layout = 0;                   ///< index into Outcome::layouts
    std::size_t page = 1;                     ///< number of its first page
    std::size_t pages = 1;                    ///< number of pages in it
    std::optional<KindHeights> heights = {};  ///< of its lines, if dots have several and the user left them to the page
};

/// A drawing on a sheet; several files may share it.
struct Layout {
    Sheet sheet;
    Place place;
    std::size_t pages = 1;  ///< of the drawing and of its key
    std::size_t strokes = 0;
    double stroke_length = 0;                 ///< mm
    std::size_t areas = 0;                    ///< black
    std::size_t textured = 0;                 ///< filled with a pattern
    bool has_picture = false;                 ///< dots rather than lines
    std::size_t text_lines = 0;               ///< braille lines, on pages of text
    bool empty = false;                       ///< nothing to feel except the title
    std::vector<std::string> names;           ///< in reading order
    MendingTold mended;                       ///< changes made for the rules
    std::optional<DetailChoice> detail = {};  ///< the chosen amount of line, if the wishes leave it to the medium
    std::vector<BrokenRule> broken;           ///< of the medium, hard ones and others
    std::vector<Page> shown;  ///< the page with the whole drawing, then those of its key; only for an output without a
                              ///< path
};

/// Pages that share a file with those of other pictures.
struct BoundPages {
    std::size_t output = 0;  ///< index of the item's output
    std::vector<Page> pages;
};

/// Everything known about one picture and its result.
struct Outcome {
    std::string input;
    int pdf_page = 0;  ///< page of a PDF, if several are made
    PictureInfo picture;
    Rect part = kWhole;                 ///< what is drawn of it, in shares of its sides
    std::string recipe;                 ///< its name
    Phrase reason;                      ///< why auto chose it; empty if the user named it
    bool keeps_some = false;            ///< keeps a part of the lines found, by a line budget; wishes can raise it
    std::vector<std::string> steps;     ///< its filters with their settings, as fitted to the medium of the first layout
    std::vector<ChosenSetting> chosen;  ///< what those filters chose for it, and why
    std::vector<Layout> layouts;
    std::vector<Made> made;
    std::vector<BoundPages> to_bind;  ///< pages of bound outputs, not yet written
    std::vector<ToldWords> words;     ///< print in the picture
    std::string model_json;           ///< of a folded-out model: what was done with its objects (model_drawing.h)
    std::string chart_json;           ///< of a chart on its first layout, if requested (chart_json.h)
    Notes notes;                      ///< for the user
    /// Files beside the outputs that are named like a further page but are no page of this picture: from an earlier run, or a
    /// person's own. They are reported and kept.
    std::vector<std::string> left_over;
    bool up_to_date = false;             ///< --update found nothing to do
    std::vector<Phrase> made_anew = {};  ///< why --update remade existing pages
    double seconds = 0;
    Phrase error;                 ///< empty: done
    Fault fault = Fault::failed;  ///< only with an error
};

/// "photo.jpg", "standard input", "book.pdf page 3": for messages.
std::string name_of_input(const Outcome& outcome);

/// Whether a page breaks a hard rule; known only if the wishes ask for the check.
bool breaks_a_rule(const Outcome& outcome);

/// The current step of a job.
enum class JobStep { reading, drawing, laying_out, writing };

/// An observer of a job.
struct Watch {
    /// Called before each step, in the thread that makes the pages; return false to cancel the job, and nothing is written.
    std::function<bool(JobStep step)> goes_on = {};
    WriteGate* gate = nullptr;                     ///< nullptr: no such lock is needed
    const std::set<std::string>* taken = nullptr;  ///< files taken by (taken_by, page_files.h) the other items of a batch;
                                                   ///< nullptr: none
};

/// Makes the pages of a picture and writes them, all or none. Never throws: the outcome holds any error. Safe from any thread.
/// The picture is read once for each size in pixels that the layouts need, so that the bytes of a file do not depend on the other
/// files made with it.
Outcome make_pages(const Job& job, const Watch& watch = {});

/// The same for an opened picture.
Outcome make_pages(Source source, const Job& job, const Watch& watch = {});

}  // namespace tactics
