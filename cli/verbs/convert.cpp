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

constexpr Flag kFlags[] = {
    {"--output", "-o", "OUT",
     "where to write: FILE, whose ending names the format; FORMAT:FILE, such as pdf:- for standard output; or "
     "FOLDER/. May be given several times",
     true, "files formats"},
    {"--to", "-t", "FORMAT", "format of the files in a folder; pdf if none is named. May be given several times", true,
     "formats"},
    {"--files-from", "", "FILE", "a list of pictures, one name a line, besides those that are named; - for standard input", false,
     "files"},
    {"--null", "-0", "", "names in the list of --files-from end in a zero byte, as find -print0 writes them", false, ""},
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
     "change a setting in every step of that filter, or of an output format: sobel.blur=0.5mm, "
     "png.dpi=600. May be given several times",
     true, "settings"},
    kDetailFlag,
    kAsDrawnFlag,
    {"--save-recipe", "", "FILE", "write the recipe that was used", false, "files"},
    {"--paper", "-p", "PAPER",
     "paper of every output: a name or a size such as 200x150mm; each format has its own if none is named", false, "papers"},
    {"--medium", "-m", "MEDIUM", "what is printed on; each format has its own if none is named", false, "media"},
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
     "your own words for what is on the page, in place of those of tactics describe: the alternative text of pdf, svg and ebrl",
     false, ""},
    kLanguageFlag,
    kBareFlag,
    {"--dpi", "", "NUMBER", "dots per inch of png and tiff, short for --set png.dpi=NUMBER --set tiff.dpi=NUMBER", false, ""},
    kJobsFlag,
    {"--update", "-u", "",
     "leave out pictures whose pages are all there and were made of the same picture with the same settings, recipe, labels and "
     "version, which is kept in .tactics beside them; of the others it is told why they are made anew. To go on with a batch "
     "that was cut short, or after a change. One file of all pictures is made again if one of them is another",
     false, ""},
    {"--no-sync", "", "",
     "do not wait until pages are on the disk: quicker for many files, but a power cut may lose pages that were reported as done",
     false, ""},
    {"--strict", "", "",
     "exit code 3 if a page breaks a hard rule, as tactics check --strict has it; the files are written, and the rules are told. "
     "Pages that --update leaves out are not looked at",
     false, ""},
    {"--quiet", "-q", "", "say nothing but errors", false, ""},
    {"--warnings", "", "",
     "say only what a person must act on, a line each: words that are left out, pages that are not fit to be felt or are empty, "
     "hard rules broken, cells cut, pictures that failed",
     false, ""},
    {"--verbose", "-v", "", "say everything of each of several pictures, too: what was chosen, why, and what was changed", false,
     ""},
    {"--progress", "", "none|lines|bar",
     "how it is told how far several pictures are: lines every five seconds, or a bar, one line that updates itself; a bar on a "
     "terminal if none is named, else lines. Never a bar where TERM is dumb or NO_COLOR is set",
     false, "none lines bar"},
    {"--json", "", "", "tell the results on standard output instead, one JSON object for each picture", false, ""},
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

// An unknown table is told once, before any work; also one that no title needs, if it was asked for.
void check_braille(const Request& request, bool named) {
    const Sheet& sheet = request.sheet;
    if (sheet.braille_table.empty()) return;
    if (named || request.title_from_name || !sheet.title.empty()) to_braille(sheet.title, sheet.braille_table);
}

int run(const Given& given) {
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
        "(VRML, "
        "X3D, STL, OBJ, PLY, glTF, COLLADA), seen from above: a file, or - for standard input. What it holds decides, not its "
        "name. Each -o is a file to write; the "
        "picture is laid out afresh for "
        "the paper and the medium of each. Several pictures go into one file in their order, if its format holds many pages, as "
        "a pdf does, whose outline names them; or "
        "into a folder, where each page takes the name of its picture. A folder "
        "that ends in / is made if it is missing. Two pictures that would get one name are refused before work starts; a file "
        "that is there already is replaced as a whole, and of a picture that fails no file is written.\n\n"
        "Of a PDF a page without pixels keeps its lines and its text; with them, or with --recipe or --filter, it is a picture. "
        "A page "
        "that is text is refused, unless --text lays it out in braille.\n\n"
        "Labels that have no room get two letters, and the key to them a page of its own if it has no room either. A pdf, ps, "
        "tiff, brf, ebrl or txt holds all pages; of others page 2 goes to a file beside the first, such as page-2.png.\n\n"
        "A recipe without the filter resample gets it put in front. No picture is looked at finer than its medium shows (150 "
        "dots per inch, embossers 30), or at more than 4,000 pixels a side. The recipe auto looks at the picture alone, so all "
        "pages of a picture are made in the same way, and says what it chose and why.\n\n"
        "What was made is told on standard error. A page that has nothing to feel is written and told, as is one that is not fit "
        "to be "
        "felt or, as far as recipe photo can tell, to be handed out; a batch lists these at its end. The exit code stays 0, "
        "unless "
        "--strict finds a hard rule broken. Of one picture everything is told, of each of several a line and what a person must "
        "act on. "
        "In a batch a picture that fails does not stop the others; failures are told at once and again at the end. Ctrl-C "
        "leaves no half-written file.",
    .example =
        "tactics convert photo.jpg -o photo.pdf\n"
        "tactics convert photo.jpg -o page.pdf -o page.svg -o page.brf --title \"Hot air balloon\"\n"
        "tactics convert photos/*.jpg -o pages/ --title-from-name --update\n"
        "tactics convert photos/*.jpg -o all.pdf --title-from-name\n"
        "find photos -name '*.jpg' -print0 | tactics convert --files-from - -0 -o pages/ --warnings\n"
        "tactics convert photo.jpg -o page.png --filter \"sobel blur=0.5mm\" --filter threshold\n"
        "tactics convert book.pdf --text -o book.brf\n"
        "cat photo.jpg | tactics convert - -o pdf:- > page.pdf",
    .flags = kFlags,
    .offers = "files",
    .takes_kept = true,
    .run = run,
};

}  // namespace tactics
