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

constexpr Flag kChartFlags[] = {
    {"--output", "-o", "OUT",
     "where to write: FILE, whose ending chooses the format, or FORMAT:FILE, as in convert. May be given several times", true,
     "files formats"},
    kTableXFlag,
    kTableYFlag,
    kTableZFlag,
    kTableGroupFlag,
    {"--label", "", "COLUMN", "column of words: each row that has some gets a disc with a letter, which the key explains", false,
     ""},
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
    {"--paper", "-p", "PAPER", "paper: a name or a size such as 200x150mm; by default each format has its own", false, "papers"},
    {"--medium", "-m", "MEDIUM", "what the page is made on; by default each format has its own", false, "media"},
    kMarginFlag,
    {"--orientation", "", "auto|portrait|landscape", "which way up the paper is", false, "auto portrait landscape"},
    {"--title", "", "TEXT", "title; by default it says which column is drawn against which", false, ""},
    kCaptionFlag,
    kNoPrintTitleFlag,
    {"--braille", "", "TABLE|none", "liblouis table for all words; default: en-ueb-g2.ctb", false,
     "en-ueb-g1.ctb en-ueb-g2.ctb none"},
    {"--language", "", "TAG",
     "language of the page, such as en-GB or de; it also decides whether the axes write 0.5 or 0,5. Default: en, with numbers "
     "written as in the table",
     false, ""},
    {"--dpi", "", "NUMBER", "dots per inch of png and tiff", false, ""},
    {"--json", "", "",
     "one JSON object on standard output: the files, the chart with all its values, and where its axes place them on the page",
     false, ""},
    {"--quiet", "-q", "", "nothing but errors", false, ""},
};

int run_chart(const Given& given) {
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
        "stand between commas, tabs, semicolons or blanks; numbers are written 0.53 throughout or 0,53 throughout, dates "
        "2024-02-29 or 2024-02-29T13:05:07Z. If all values in the first line are numbers, the columns are called x and y, or "
        "\"column 1\" and so on. Rows of a curve are joined in file order. Where y is unknown (an empty cell, NaN or NA) the "
        "curve has a gap; a row without x is left out. Up to 20 million rows are read.\n\n"
        "JSON is also read: [{\"time\": 1, \"F\": 0.5}, ...], [[1, 0.5], ...], {\"time\": [1, 2], \"F\": [0.5, 0.6]} or one "
        "array of numbers; null is a gap. Rows of x, y and z and {\"x\": [...], \"y\": [...], \"z\": [[...], ...]} are "
        "surfaces.\n\n"
        "--bars draws one bar for each row, named by its words. Bars begin at 0, which the axis always shows; five textures "
        "distinguish columns or groups, and the key shows them. If the names have no room below the bars, the bars run to the "
        "right; if they have no room there either, letters replace them and the key explains the letters. A pie is drawn as "
        "bars of its shares, since a finger compares lengths, not angles. A missing value and a value of 0 have no bar.\n\n"
        "--x and --y take a column's name with or without its unit. The axes have ticks with numbers. Up to five curves each "
        "get a line style: solid, dashed, thick, dotted and thick dashed. An embosser has no thick lines and puts dots between "
        "the dashes instead. With more curves, each gets a letter. Each group of points gets a symbol, each marked point a "
        "letter. The key below shows lines and symbols as they feel. Points too close to be told apart are drawn as one, and a "
        "curve that rises and falls faster than a finger can follow is drawn through fewer of its points; tactics reports both.",
    .example =
        "tactics chart results.csv -o chart.pdf\n"
        "tactics chart sales.csv --bars grouped --y 2023 --y 2024 -o sales.pdf -o sales.brf\n"
        "tactics chart results.csv --x \"dots a page\" --y F --group tool --label method --log-x -o chart.pdf -o chart.brf\n"
        "cut -d, -f2,5 measured.csv | tactics chart - --points -o points.svg --title \"Height and age\"",
    .flags = kChartFlags,
    .offers = "files",
    .takes_kept = true,
    .run = run_chart,
};

}  // namespace tactics
