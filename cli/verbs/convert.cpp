// SPDX-License-Identifier: Apache-2.0
// `tactics convert`: pictures in, pages out.
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "cli/batch.h"
#include "cli/command.h"
#include "cli/model_flags.h"
#include "cli/page_flags.h"
#include "cli/report/say.h"
#include "cli/table_flags.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/job/disk.h"
#include "tactics/layout/sheet.h"
#include "tactics/transport/file.h"

namespace tactics {

namespace {

constexpr Flag kConvertFlags[] = {
    {"--output", "-o", "OUT",
     "where to write: FILE, whose ending chooses the format; FORMAT:FILE, such as pdf:- for standard output; or FOLDER/. May be "
     "given several times",
     true, "files formats"},
    {"--to", "-t", "FORMAT", "format of the files in a folder; default: pdf. May be given several times", true, "formats"},
    {"--files-from", "", "FILE", "a file that lists further pictures, one name per line; - for standard input", false, "files"},
    {"--null", "-0", "", "names in the --files-from list end in a zero byte, as find -print0 writes them", false, ""},
    kPdfPagesFlag,
    kTextFlag,
    kAllowFlag,
#include "cli/table_flags.inc"
#include "cli/table_flags_of_bars.inc"
    kModelFlag,
    kModelPartFlag,
    kFoldFlag,
    kReaderFlag,
    kRecipeFlag,
    kFilterFlag,
    {"--set", "-s", "NAME.OPTION=VALUE",
     "change a setting in every step of a filter, or of an output format: sobel.blur=0.5mm, png.dpi=600. May be given several "
     "times",
     true, "settings"},
    kDetailFlag,
    kAsDrawnFlag,
    {"--save-recipe", "", "FILE", "write the recipe that was used to this file", false, "files"},
    {"--paper", "-p", "PAPER", "paper of every output: a name or a size such as 200x150mm; by default each format has its own",
     false, "papers"},
    {"--medium", "-m", "MEDIUM", "what the page is made on; by default each format has its own", false, "media"},
    {"--embosser", "", "NAME",
     "lay out outputs that belong to no machine, such as svg and pdf, for this one of tactics list embossers: to look at its "
     "dots, or to edit a page before it is embossed",
     false, "embossers displays"},
    kMarginFlag,
    kBindingFlag,
    kDuplexFlag,
    kTilesFlag,
    kOrientationFlag,
    kWidthFlag,
    kRealWidthFlag,
    kScaleFlag,
    kTitleFlag,
    kTitleFromNameFlag,
    kCaptionFlag,
    kNoPrintTitleFlag,
    kBrailleFlag,
    kCellFlag,
    kSubjectFlag,
    kSubjectOnlyFlag,
    kLeaveFlag,
    kLabelFlag,
    kLabelsFlag,
    kWordsFlag,
    {"--describe", "", "TEXT",
     "your own description of the page, in place of the one from tactics describe; it becomes the alternative text of pdf, svg "
     "and ebrl",
     false, ""},
    kLanguageFlag,
    kBareFlag,
    {"--dpi", "", "NUMBER", "dots per inch of png and tiff, short for --set png.dpi=NUMBER --set tiff.dpi=NUMBER", false, ""},
    kJobsFlag,
    {"--update", "-u", "",
     "skip pictures whose pages are all there and were made from the same picture with the same settings, recipe, labels and "
     "version; the folder .tactics beside the pages records these. For the others, say why they are made anew. Use it to resume "
     "a batch that was cut short, or after a change. A file of several pictures is made anew if one of them has changed",
     false, ""},
    {"--no-sync", "", "",
     "do not wait until pages reach the disk: quicker for many files, but a power cut may lose pages reported as done", false,
     ""},
    {"--strict", "", "",
     "exit code 3 if a page breaks a hard rule, as with tactics check --strict; the files are still written. Broken rules are "
     "reported with and without it",
     false, ""},
    {"--quiet", "-q", "", "say nothing but errors", false, ""},
    {"--warnings", "", "",
     "say only what a person must act on, one line each: words left out, pages that are empty or not fit to be felt, hard rules "
     "broken, cells cut off, pictures that failed",
     false, ""},
    {"--verbose", "-v", "",
     "say everything about each picture of a batch, too: what was chosen and why, what was "
     "changed, and which rules a page misses",
     false, ""},
    {"--progress", "", "none|lines|bar",
     "how to report the progress of several pictures: a line every five seconds, or a bar, one line that updates itself. "
     "Default: a bar on a terminal, else lines. Never a bar if TERM is dumb or NO_COLOR is set",
     false, "none lines bar"},
    {"--json", "", "", "write the results to standard output instead, one JSON object for each picture", false, ""},
};

// The folders of the outputs, made if they are missing. One that is made and stays empty, as no picture could be
// converted, is taken away in the end.
class Folders {
public:
    Folders() = default;
    ~Folders() {
        for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) rmdir(folder->c_str());
    }
    Folders(const Folders&) = delete;
    Folders& operator=(const Folders&) = delete;

    void make(const std::filesystem::path& folder) {
        std::filesystem::path part;
        for (const auto& name : folder) {
            part /= name;
            std::error_code fault;
            if (std::filesystem::is_directory(part, fault)) continue;
            if (std::filesystem::create_directory(part, fault)) {
                made_.push_back(part);
                keep_folder(part.has_parent_path() ? part.parent_path().string() : ".");
            }
            if (fault)
                throw Error(Fault::failed, folder.string(),
                            phrase("this folder cannot be made: {0}; choose another place", fault.message()));
        }
    }

private:
    std::vector<std::filesystem::path> made_;
};

// Reports an unknown table once, before any work, even if no title needs it.
void check_braille(const Request& request, bool named) {
    const Sheet& sheet = request.sheet;
    if (sheet.braille_table.empty()) return;
    if (named || request.title_from_name || !sheet.title.empty()) to_braille(sheet.title, sheet.braille_table);
}

int run_convert(const Given& given) {
    Request request = plan(given, real_disk());
    check_braille(request, given.has("--braille"));
    Folders folders;
    for (const Output& output : request.items.front().outputs)  // every picture goes into the same folders
        if (!output.folder.empty()) folders.make(output.folder);
    if (!request.save_recipe.empty() && request.recipe) write_file(request.save_recipe, to_text(saved_recipe(request)));
    if (request.loudness == Loudness::usual || request.loudness == Loudness::all)
        for (const Phrase& note : request.notes) say(note);
    return run_batch(request);
}

}  // namespace

extern const Command convert_command;
const Command convert_command{
    .name = "convert",
    .summary = "make tactile pages from pictures",
    .words = "INPUT... -o OUT [-o OUT]...",
    .details =
        "INPUT is a picture, a figure (SVG, a page of a PDF), a table of numbers (CSV, drawn as chart draws it) or a model "
        "(VRML, X3D, STL, OBJ, PLY, glTF, COLLADA), seen from above: a file, or - for standard input. Its contents decide what "
        "it is, not its name. Each -o is a file to write; the picture is laid out afresh for the paper and medium of each. "
        "Several pictures go in order into one file, if its format holds many pages, as a pdf does, whose outline names them; "
        "or into a folder, where each page takes the name of its picture. A folder whose name ends in / is made if it is "
        "missing. Two pictures that would get the same file name are refused before work starts. An existing file is replaced "
        "as a whole, and a picture that fails leaves no file.\n\n"
        "A PDF page without pixels keeps its lines and its text; a page with pixels, or with --recipe or --filter given, is a "
        "picture. A page of text is refused, unless --text lays it out in braille.\n\n"
        "A label that has no room is replaced by two letters, which a key explains; a key that has no room gets a page of its "
        "own. A pdf, ps, tiff, brf, ebrl or txt file holds all pages; other formats write page 2 to a file beside the first, "
        "such as page-2.png.\n\n"
        "A recipe without the filter resample gets it as its first step. No picture is processed at a finer resolution than its "
        "medium shows (150 dots per inch, embossers 30), or at more than 4,000 pixels a side. The recipe auto decides from the "
        "picture alone, so all pages of a picture are made in the same way; it says what it chose and why.\n\n"
        "--detail best tries nine amounts of line for each medium, from a quarter to four times the usual one. Each line of the "
        "recipes photo, portrait and others that end in outlines has a chance that people would draw it. The measure is how many "
        "bits the page, mended for its medium, tells about where people would draw, to a reader who follows as much line as the "
        "recipe usually allows: the mutual information, not the bits of the page, which clutter has most of. Of the amounts that "
        "break the fewest hard rules, the one that loses the least is taken, or the one nearest to the usual that loses at most "
        "2 % more of the bits. The size is not chosen: a drawing is as large as its sheet allows, and a medium never carries "
        "less of a larger one (tactics help measure).\n\n"
        "Where dots have several heights (graphiti, viewplus), the drawing and braille stand highest, and axes, grid lines and "
        "patterns lower. The page takes the number of heights that loses the least of the bits about what a line is for, the "
        "fewest if several do: one where all lines are of one kind. The report says which, and what fewer would lose. A height "
        "that you set, such as --set graphiti.axes=3, is kept.\n\n"
        "The report goes to standard error. A page that is empty, not fit to be felt or, as far as recipe photo can judge, not "
        "fit to be handed out is written and reported; a batch counts these pages at its end and names up to ten. The exit code "
        "stays 0, unless --strict finds a hard rule broken. One picture gets a full report; each of several gets one line, which "
        "also says what a person must act on. In a batch, a picture that fails does not stop the others; failures are reported "
        "at once and again at the end. Ctrl-C leaves no half-written file.",
    .example =
        "tactics convert photo.jpg -o photo.pdf\n"
        "tactics convert photo.jpg -o page.pdf -o page.svg -o page.brf --title \"Hot air balloon\"\n"
        "tactics convert photos/*.jpg -o pages/ --title-from-name --update\n"
        "tactics convert photos/*.jpg -o all.pdf --title-from-name\n"
        "find photos -name '*.jpg' -print0 | tactics convert --files-from - -0 -o pages/ --warnings\n"
        "tactics convert photo.jpg -o page.png --filter \"sobel blur=0.5mm\" --filter threshold\n"
        "tactics convert book.pdf --text -o book.brf\n"
        "cat photo.jpg | tactics convert - -o pdf:- > page.pdf",
    .flags = kConvertFlags,
    .offers = "files",
    .takes_kept = true,
    .run = run_convert,
};

}  // namespace tactics
