// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate`: recipes against contours that people drew.
#include <cmath>

#include "cli/command.h"
#include "cli/report/say.h"
#include "cli/verbs/evaluate_chart.h"
#include "cli/verbs/evaluate_matching.h"
#include "cli/verbs/evaluate_needed.h"
#include "cli/verbs/evaluate_page.h"
#include "cli/verbs/evaluate_regions.h"
#include "cli/verbs/evaluate_repair.h"
#include "cli/verbs/evaluate_report.h"
#include "cli/verbs/evaluate_run.h"
#include "cli/verbs/evaluate_stability.h"
#include "cli/verbs/evaluate_subject.h"
#include "tactics/error.h"
#include "tactics/transport/file.h"

namespace tactics {

namespace {

constexpr Flag kFlags[] = {
    {"--recipe", "-r", "NAME|FILE",
     "a recipe's name or a recipe file; all of them and auto if none is named. May be given several times", true,
     "recipes files"},
    {"--filter", "-f", "\"NAME SETTING=VALUE...\"",
     "a step of your own. May be given several times: alone they are the whole recipe, with --recipe they come after the steps "
     "of each",
     true, "filters"},
    {"--set", "-s", "NAME.OPTION=VALUE", "change a setting in every step of that filter. May be given several times", true,
     "settings"},
    {"--truth", "", "FOLDER", "the folder of the contour maps; gt in FOLDER if none is named", false, "folders"},
    {"--sweep", "", "FILTER.OPTION=V1,V2...",
     "run each recipe that has the filter once with each value; its F is that of the best value, the same for all pictures",
     false, "settings"},
    {"--detail", "", "touch|contours|NUMBER", "as in convert; of all recipes, those that keep the strongest lines follow it",
     false, "touch contours"},
    {"--study", "", "matching|needed|page|regions|repair|stability|subject",
     "another question than F, see below; matching, repair and stability need no contour maps", false,
     "matching needed page regions repair stability subject"},
    {"--seed", "", "NUMBER", "of --study matching: another number, other simulated readers; 1 if none is named", false, ""},
    {"--paper", "-p", "PAPER",
     "paper that the drawing would be printed on, which says how large it is; that of pdf if none is named", false, "papers"},
    {"--medium", "-m", "MEDIUM", "what it would be printed on; that of pdf if none is named", false, "media"},
    {"--margin", "", "LENGTH", "margin on every side; the medium's own if none is named", false, ""},
    {"--half", "", "even|odd|all",
     "every second picture in the order of their names, counted from 1: tune on one half and measure on the other", false,
     "even odd all"},
    {"--jobs", "-j", "NUMBER", "how many pictures are worked on at a time; as many as there are cores if none is named", false,
     ""},
    {"--csv", "", "FILE", "write the table with commas, too; - is standard output, and then instead", false, "files"},
    {"--chart", "", "FILE",
     "draw F against time, to be felt: a page whose ending names the format, as in convert. May be given several times", true,
     "files"},
    {"--orientation", "", "auto|portrait|landscape", "which way up the paper of a chart is", false, "auto portrait landscape"},
    {"--title", "", "TEXT", "title of a chart in place of its own", false, ""},
    {"--no-print-title", "", "", "the words of a chart in braille only", false, ""},
    {"--braille", "", "TABLE|none", "liblouis table for the words of a chart; en-ueb-g2.ctb if none is named", false,
     "en-ueb-g1.ctb en-ueb-g2.ctb none"},
    {"--dpi", "", "NUMBER", "dots per inch of a chart in png and tiff", false, ""},
    {"--quiet", "-q", "", "no progress, and nothing besides the table but errors", false, ""},
    {"--json", "", "",
     "the results as one JSON object a line instead of the table: each recipe with all its pictures, people, and the whole",
     false, ""},
};

// Gives the exit code.
int sum_up(const EvaluateRequest& request, const Evaluation& evaluation) {
    if (!request.quiet) {
        for (const auto& line : nothing_lines(evaluation)) say(line);
        std::size_t maps = 0;
        for (const std::size_t annotators : evaluation.annotators) maps += annotators;
        say(std::to_string(evaluation.pictures.size()) + (evaluation.pictures.size() == 1 ? " picture" : " pictures") + " with " +
            std::to_string(maps) + " contour maps, as drawn for " + std::string(request.sheet.medium->name) + " on " +
            std::string(request.sheet.paper.name) + "; peak memory " + std::to_string(std::lround(evaluation.peak_memory_mib)) +
            " MiB");
    }
    return tell_problems(evaluation.problems, "scored");
}

int run(const Given& given) {
    const EvaluateRequest request = plan_evaluation(given, real_disk());
    if (request.study == "matching") return run_matching_study(request);
    if (request.study == "stability") return study_stability(request);
    if (request.study == "repair") return run_repair_study(request);
    if (request.study == "needed") return run_needed_study(request);
    if (request.study == "page") return run_page_study(request);
    if (request.study == "regions") return run_region_study(request);
    if (request.study == "subject") return run_subject_study(request, find_subjects);
    const Evaluation evaluation = evaluate(request);
    if (request.csv != "-") print_out(request.json ? evaluation_json(evaluation) : evaluation_table(evaluation));
    if (!request.csv.empty()) write_file(request.csv, evaluation_csv(evaluation));
    const int code = sum_up(request, evaluation);
    if (!request.charts.empty()) write_charts(frontier_plot(evaluation), request.charts);
    return code;
}

}  // namespace

extern const Command evaluate_command;
const Command evaluate_command{
    .name = "evaluate",
    .summary = "score recipes against contours that people drew of the same pictures",
    .words = "FOLDER",
    .details =
        "FOLDER holds pictures in images/ and, in gt/, the contour maps that people drew of them: NAME_gt1.png, NAME_gt2.png and "
        "so on for picture NAME, of the same size, white lines on black. Without images/ the pictures are in FOLDER itself; "
        "--truth names another place for the maps.\n\n"
        "Scores are those of the Berkeley benchmark: lines are thinned to one pixel and matched one to one with each person's "
        "pixels within 0.75 percent of the diagonal. P (precision) is the share of the lines that anybody drew, R (recall) the "
        "share "
        "of what all of them drew that was found, F their harmonic mean. F, P and R are at the dial that is best for all "
        "pictures "
        "together (ODS); OIS F lets each picture have its own. The row people scores each person against the others, the row "
        "simplest person the "
        "one whose map of a picture has the fewest regions.\n\n"
        "The dial is the strength below which lines are left out, where a recipe gives strengths, and the value of --sweep. "
        "Scored "
        "are the strokes and the outlines of areas of a drawing; of an edge map all pixels as strong as the dial says; of a "
        "picture "
        "the borders between parts of different value. An edge map is not cut before it is scored.\n\n"
        "Line mm and strokes are means of a drawing as the recipe makes it; crowded is the share of its line that runs closer to "
        "another line than the medium's gap. CPU ms is the median time of a picture for the recipe alone, then with choosing and "
        "reading. Nothing counts the pictures on which no line was drawn; they are scored.\n\n"
        "--study matching is the pilot study of TACTICS with simulated readers: of each picture a square sheet of 2.5 in is "
        "made, "
        "and a fingertip of limited acuity, sureness of place and memory looks for each sheet among all of its kind, in sets of "
        "at "
        "most 20. Matched is how often it finds it; the 95 percent are the readers' luck, not that of other pictures. Random "
        "readers is the middle rate of 60 readers whose parameters are drawn at random; the rates with one parameter changed "
        "follow. It is a simulation: the reader has not been checked on people.\n\n"
        "--study stability asks how much of a drawing stays when its picture changes: F between what a recipe draws on the "
        "picture and on the changed one, put back onto the picture, matched one to one within 0.75 percent of the diagonal; 1 if "
        "both are empty, 0 if one is. Columns are means over the pictures, each seen at 500 pixels at most: JPEG 70 and 50 "
        "(quality, colour at half resolution), noise 10 (deviation in grey levels), shift (one pixel right and down), turn (one "
        "degree about the middle), crop (a twentieth off each side; the rest keeps its scale), half (half as many pixels each "
        "way), gamma 0.8, low and very low (contrast times 0.5 and 0.2 about middle grey), dark 0.3 and 0.1 (grey values times "
        "that), bright 1.2 (overexposed, cut off at white), start (four other seeds of each kmeans). Then pictures with nothing "
        "to find, with the share of pixels that became "
        "line, and two discs, with the F of their circle: one 4 grey levels above its ground with noise of 3, one that only its "
        "colour tells. --json has the worst picture of each column, too. Where pictures of 500 pixels at most have contour maps, "
        "a second table tells by how much P3 (see --study page) changes from the drawing of the picture to that of the changed "
        "one: in the mean, on the worst page, and on how many pages it falls by 0.05 or more.\n\n"
        "--chart draws F against the time of a picture with reading, a mark for each recipe: a disc if no other is both faster "
        "and "
        "better, and a curve joins these; a ring otherwise. A level line is what the simplest person reaches. --paper, --medium "
        "and --margin are the chart's, too.\n\n"
        "--study needed turns one dial at a time, for auto if no recipe is named: grey levels left by K-means before the edges "
        "are "
        "found (256: grey, all of them), dots per inch of the page at which it works, and strokes kept, the strongest and "
        "longest "
        "first. F is that of all that is drawn. Enough is the least value of a picture with F within 1 percent of the best of "
        "that "
        "dial; the table has the value that is enough for a quarter, half and three quarters of the pictures, the median that "
        "the "
        "recipe has by itself, on how many pictures that is more than needed, and the mean F at each value. --chart writes a "
        "page "
        "for each dial: chart-levels.pdf, chart-dpi.pdf, chart-strokes.pdf.\n\n"
        "--study repair makes the page of each picture, mends it as convert does, and tells how many pages broke a hard rule, at "
        "how "
        "many places before and after, how many are not fit to be felt in this size (the user is told to split, to enlarge or to "
        "describe the picture), R and F of all that is drawn before and after, the share of line that stays, and CPU seconds: of "
        "a page from picture to PDF and of its repair, medians, and of the longest repair. --chart draws places against R.\n\n"
        "--study page scores the page as convert makes it, mended, by its line: P3 and P1 are the shares that run within 0.75 "
        "percent "
        "of the diagonal of a line that at least 3 people, at least 1 drew; R3 is the share of the lines of at least 3 people "
        "that "
        "is drawn; main object the share of the outline of the largest thing that each person drew whole; diagonals the pixels "
        "of "
        "line. An end of a line is loose if it is not within 4 mm of another line, of its own other end or of the side of all "
        "that "
        "is drawn; whole is the share of line without loose ends. Lines, mm, loose ends and CPU ms (from the picture to the "
        "mended "
        "drawing) are medians, the others means. The row simplest person is what the person with the fewest regions of a picture "
        "drew of it, as a page, against the others. --chart draws P3 and R3 against time: chart-p3.pdf, chart-r3.pdf. A recipe "
        "that "
        "expects something of its pages has a second table: P3 and R3 as expected and as they are, by the harmonic mean of the "
        "two "
        "that was expected, and how many pages are poor. A page is poor if less than two thirds of its line is agreed on, or "
        "less than 0.45 of "
        "what is agreed on is drawn and less than 0.6 of the main object, and the simplest person is better in that by 0.1.\n\n"
        "--study regions scores the regions that a recipe finds, those that its lines enclose, as the Berkeley benchmark does: "
        "covering is how much of people's regions the best of the recipe's cover (intersection over union), PRI the "
        "Probabilistic "
        "Rand Index, VI the Variation of Information in bits (less is better). Columns without a word are at the strength that "
        "is "
        "best for all pictures together (ODS), OIS lets each picture have its own, best each region. What a line covers belongs "
        "to "
        "the nearest region.\n\n"
        "--study subject points at the things that at least 3 people agree on (regions that overlap by 0.7, 2 to 50 percent of "
        "the "
        "picture, not at all four sides), with a box around them and with a point deep inside, and tells how well what is then "
        "found "
        "covers them: IoU is intersection over union, found the share with 0.5 or more. A recipe with the filters nest and "
        "outlines finds it as convert --subject does, others among the regions that their lines enclose. The row the box alone "
        "takes all that is in the box.\n\n"
        "What cannot be scored is named and left out, the rest is reported, and the exit code is 2.",
    .example =
        "tactics evaluate photos/\n"
        "tactics evaluate photos/ -r photo -r my.recipe --detail contours --csv table.csv\n"
        "tactics evaluate photos/ --half odd -f \"sobel blur=1mm thin=yes\"\n"
        "tactics evaluate photos/ -f kmeans --sweep kmeans.k=2,3,4,6 --json\n"
        "tactics evaluate photos/ --study stability\n"
        "tactics evaluate photos/ --study matching\n"
        "tactics evaluate photos/ --study repair --chart repair.pdf\n"
        "tactics evaluate photos/ --study page --half odd --chart page.pdf\n"
        "tactics evaluate photos/ --chart frontier.pdf --chart frontier.brf\n"
        "tactics evaluate photos/ --study needed -r photo",
    .flags = kFlags,
    .offers = "folders",
    .run = run,
};

}  // namespace tactics
