// SPDX-License-Identifier: Apache-2.0
// `tactics chart`: a table of figures as a page to be felt.
#include "cli/chart_flags.h"
#include "cli/command.h"
#include "cli/outputs.h"
#include "cli/page_flags.h"
#include "cli/report/report.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/table_flags.h"
#include "tactics/error.h"
#include "tactics/job/make_pages.h"

namespace tactics {

namespace {

constexpr Flag kFlags[] = {
    {"--output", "-o", "OUT",
     "where to write: FILE, whose ending names the format, or FORMAT:FILE, as in convert. May be given several times", true,
     "files formats"},
    kTableXFlag,
    kTableYFlag,
    kTableZFlag,
    kTableGroupFlag,
    {"--label", "", "COLUMN", "a row with words in it is marked by a disc with a letter, and the key has the words", false, ""},
    kTablePointsFlag,
    kTableStepsFlag,
    kTableHistogramFlag,
    kTableMatrixFlag,
#include "cli/table_flags_of_bars.inc"
    kTableLogXFlag,
    kTableLogYFlag,
    kTableDecimalFlag,
    kTableDatesFlag,
    kChartGridFlag,
    kChartViewFlag,
    kChartLevelsFlag,
    kChartSectionFlag,
    {"--set", "-s", "FORMAT.OPTION=VALUE", "change a setting of an output format: png.width=800. May be given several times",
     true, "settings"},
    {"--paper", "-p", "PAPER", "paper: a name or a size such as 200x150mm; each format has its own if none is named", false,
     "papers"},
    {"--medium", "-m", "MEDIUM", "what is printed on; each format has its own if none is named", false, "media"},
    kMarginFlag,
    {"--orientation", "", "auto|portrait|landscape", "which way up the paper is", false, "auto portrait landscape"},
    {"--title", "", "TEXT", "title; what is shown against what if none is named", false, ""},
    kCaptionFlag,
    kNoPrintTitleFlag,
    {"--braille", "", "TABLE|none", "liblouis table for all words; en-ueb-g2.ctb if none is named", false,
     "en-ueb-g1.ctb en-ueb-g2.ctb none"},
    {"--language", "", "TAG",
     "language of the page, such as en-GB or de, which also says whether the axes write 0.5 or 0,5; en, and as in the table, if "
     "none is named",
     false, ""},
    {"--dpi", "", "NUMBER", "dots per inch of png and tiff", false, ""},
    {"--json", "", "",
     "one JSON object on standard output: the files, and the chart with all its values, and where on the page its axes have them",
     false, ""},
    {"--quiet", "-q", "", "nothing but errors", false, ""},
};

int run(const Given& given) {
    if (given.words.size() != 1) throw Error(Fault::usage, "chart", phrase("name one file of figures, or - for standard input"));
    if (!given.has("--output")) throw Error(Fault::usage, "chart", phrase("say where to write it: -o chart.pdf"));
    Request request = plan_charts(plan_outputs({given.words[0]}, named_outputs(given), {}, real_disk()), given);
    request.table = table_wish(given);
    request.table.label = given.value("--label");
    request.tables_only = true;
    request.chart = chart_wish(given);
    request.chart.told = given.has("--json");
    const Item& item = request.items.front();
    for (const Output& output : item.outputs)
        if (!output.folder.empty())
            throw Error(Fault::usage, "-o " + output.folder, phrase("this is a folder; name a file, for example chart.pdf"));
        else if (output.path == "-" && given.has("--json"))
            throw Error(Fault::usage, "--json", phrase("the page goes to standard output already; name a file for it"));
    const Outcome outcome = make_pages(Job{item, request});
    if (!given.has("--quiet") && !given.has("--json"))
        for (const Note& note : outcome.notes) say(phrase("{0}: {1}", outcome.input, note.words));
    if (!outcome.error.empty()) throw Error(outcome.fault, "", outcome.error);
    if (given.has("--json")) print_out(result_json(outcome) + "\n");
    return 0;
}

}  // namespace

extern const Command chart_command;
const Command chart_command{
    .name = "chart",
    .summary = "draw a table of figures as curves, points or bars to be felt",
    .words = "FILE.csv -o OUT",
    .details =
        "The first line of the file names the columns, with units in parentheses: dots a page,F or time (s),length (mm). Values "
        "stand "
        "between commas, tabs, semicolons or blanks; numbers are written 0.53 or, all of them, 0,53, dates 2024-02-29 or "
        "2024-02-29T13:05:07Z. Where all values of the first line are numbers, columns are x and y, or \"column 1\". Rows of a "
        "curve are joined in their order. Where nothing is known of y, an empty cell, NaN or NA, the curve has a gap; a row "
        "without x "
        "is left out. Up to 20 million rows are read.\n\n"
        "JSON is read, too: [{\"time\": 1, \"F\": 0.5}, ...], [[1, 0.5], ...], {\"time\": [1, 2], \"F\": [0.5, 0.6]} or one "
        "array of "
        "numbers; null is a gap. Rows of x, y and z and {\"x\": [...], \"y\": [...], \"z\": [[...], ...]} are surfaces.\n\n"
        "--bars draws a bar for each row over words. Each begins at 0, which the axis always shows; five textures tell columns "
        "or "
        "groups apart, and the key shows them. Names that have no room below the bars turn these to the right, and names that "
        "have "
        "none there either are letters that the key explains. A pie is drawn as bars of its shares, since a finger compares "
        "lengths "
        "and not angles. Where nothing is known there is no bar, and so it is where a value is 0.\n\n"
        "--x and --y take a column's name with its unit or without. The axes have ticks with numbers. Up to five curves have a "
        "kind "
        "of line each: whole, dashed, thick, dotted and thick dashed, on an embosser, which has no thick lines, with dots "
        "between "
        "the dashes; more have a letter each. Groups of points have a symbol each, marked points a letter. The key below shows "
        "lines and symbols as they are felt. Points that are too near to be told apart are drawn as one, and a curve that goes "
        "up "
        "and down faster than a finger can follow goes through fewer of its points; both is told.",
    .example =
        "tactics chart results.csv -o chart.pdf\n"
        "tactics chart sales.csv --bars grouped --y 2023 --y 2024 -o sales.pdf -o sales.brf\n"
        "tactics chart results.csv --x \"dots a page\" --y F --group tool --label method --log-x -o chart.pdf -o chart.brf\n"
        "cut -d, -f2,5 measured.csv | tactics chart - --points -o points.svg --title \"Height and age\"",
    .flags = kFlags,
    .offers = "files",
    .takes_kept = true,
    .run = run,
};

}  // namespace tactics
