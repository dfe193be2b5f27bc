// SPDX-License-Identifier: Apache-2.0
// `tactics evaluate`: recipes against contours that people drew, and other questions to them: its studies.
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/page_flags.h"
#include "cli/report/progress.h"
#include "cli/report/say.h"
#include "cli/report/user_language.h"
#include "cli/verbs/evaluate_request.h"
#include "studies/frontier.h"
#include "studies/list.h"
#include "tactics/error.h"
#include "tactics/text/words.h"
#include "tactics/transport/file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// Before the option that names a study and those of studies, and after them.
constexpr Flag kBeforeStudies[] = {
    {"--recipe", "-r", "NAME|FILE",
     "a recipe's name or a recipe file; default: all recipes, and auto. May be given several times", true, "recipes files"},
    {"--filter", "-f", "\"NAME SETTING=VALUE...\"",
     "a step of your own. May be given several times: without --recipe the steps are the whole recipe, with it they follow the "
     "steps of each",
     true, "filters"},
    {"--set", "-s", "NAME.OPTION=VALUE", "change a setting in every step of a filter. May be given several times", true,
     "settings"},
    {"--truth", "", "FOLDER", "the folder of the contour maps; default: gt in FOLDER", false, "folders"},
    {"--sweep", "", "FILTER.OPTION=V1,V2...",
     "run each recipe that has the filter once with each value; its F is that of the best value, which is the same for all "
     "pictures",
     false, "settings"},
    {"--detail", "", "touch|contours|NUMBER", "as in convert; only recipes that keep the strongest lines follow it", false,
     "touch contours"},
};

constexpr Flag kAfterStudies[] = {
    {"--paper", "-p", "PAPER", "paper of the drawing, which decides its size; default: that of pdf", false, "papers"},
    {"--medium", "-m", "MEDIUM", "what the page would be made on; default: that of pdf", false, "media"},
    {"--margin", "", "LENGTH", "margin on every side; default: the medium's own", false, ""},
    kAllowFlag,
    {"--half", "", "even|odd|all",
     "use every second picture in the order of names, counted from 1, to tune on one half and measure on the other", false,
     "even odd all"},
    {"--jobs", "-j", "NUMBER", "how many pictures to work on at a time; default: the number of cores", false, ""},
    {"--csv", "", "FILE", "also write the results as CSV; - writes them to standard output instead of the table", false, "files"},
    {"--chart", "", "FILE",
     "draw F against time as a tactile page, whose ending chooses the format, as in convert. May be given several times", true,
     "files"},
    {"--orientation", "", "auto|portrait|landscape", "which way up the paper of a chart is", false, "auto portrait landscape"},
    {"--title", "", "TEXT", "title of a chart in place of its own", false, ""},
    {"--no-print-title", "", "", "write the words of a chart in braille only", false, ""},
    {"--braille", "", "TABLE|none", "liblouis table for the words of a chart; default: en-ueb-g2.ctb", false,
     "en-ueb-g1.ctb en-ueb-g2.ctb none"},
    {"--dpi", "", "NUMBER", "dots per inch of a chart in png and tiff", false, ""},
    {"--quiet", "-q", "", "print only the table and errors, no progress", false, ""},
    {"--json", "", "",
     "the results as one JSON object per line instead of the table: each recipe with all its pictures, people, and the whole",
     false, ""},
};

// All as the help has them. They live as long as the program, and so do the texts that are put together for them.
std::span<const Flag> flags() {
    static std::list<std::string> texts;
    static const std::vector<Flag> kFlags = [] {
        const auto kept = [](std::string text) -> std::string_view { return texts.emplace_back(std::move(text)); };
        std::vector<Flag> all(std::begin(kBeforeStudies), std::end(kBeforeStudies));
        const std::vector<std::string_view> names = study_names();
        std::vector<std::string_view> without_maps = names;
        std::erase_if(without_maps, [](std::string_view name) { return find_study(name)->needs_maps; });
        all.push_back(
            {"--study", "", kept(joined(names, "|", "|")),
             kept("ask another question than F, see below; " + joined(without_maps, ", ", " and ") + " need no contour maps"),
             false, kept(joined(names, " ", " "))});
        for (const Study* study : studies())
            for (const Option& option : study->options)
                all.push_back({kept("--" + std::string(option.name)), "", "NUMBER",
                               kept("for --study " + std::string(study->name) + ": " + std::string(option.summary) +
                                    "; default: " + to_text(option.fallback)),
                               false, ""});
        all.insert(all.end(), std::begin(kAfterStudies), std::end(kAfterStudies));
        return all;
    }();
    return kFlags;
}

constexpr std::string_view kDetails =
    "FOLDER holds pictures in images/ and, in gt/, the contour maps that people drew of them: NAME_gt1.png, NAME_gt2.png and so "
    "on for picture NAME, in the same size, as white lines on black. Without images/ the pictures are in FOLDER itself; --truth "
    "names another folder for the maps. A figure (SVG), a table or a model among them is drawn as convert draws it, stretched "
    "over its maps and scored like the rest, so a page drawn by hand can be measured, too.\n\n"
    "Scores are those of the Berkeley benchmark: lines are thinned to one pixel and matched one to one with each person's "
    "pixels within 0.75 percent of the diagonal. P (precision) is the share of the recipe's lines that at least one person "
    "drew; R (recall) is the share of all people's lines that the recipe found; F is the harmonic mean of the two. F, P and R "
    "are taken at the dial that is best for all pictures together (ODS); OIS F takes the best dial for each picture. The row "
    "people scores each person against the others, the row simplest person the one whose map of a picture has the fewest "
    "regions.\n\n"
    "The dial is the strength below which lines are left out, for a recipe that gives strengths, and the value of --sweep. In a "
    "drawing, the strokes and the outlines of areas are scored; in an edge map, all pixels at least as strong as the dial; in a "
    "picture, the borders between parts of different value. An edge map is not cut before it is scored.\n\n"
    "Line mm and strokes are the mean length of line and number of strokes in the drawings as the recipe makes them; crowded is "
    "the share of the line that runs closer to another line than the medium's gap. CPU ms is the median time for a picture: "
    "first of the recipe alone, then with choosing and reading. The column nothing counts the pictures on which no line was "
    "drawn; they are scored, too.\n\n";
constexpr std::string_view kEndOfDetails =
    "Files that cannot be scored are named and left out; the rest are reported, and the exit code is 2.";

std::string_view details() {
    static const std::string kText = [] {
        std::string text(kDetails);
        for (const Study* study : studies()) {
            if (!study->name.empty()) text += "--study " + std::string(study->name) + " ";
            text += std::string(study->details) + "\n\n";
        }
        return text + std::string(kEndOfDetails);
    }();
    return kText;
}

// How far it is, and what goes wrong, as it happens.
class Telling {
public:
    explicit Telling(bool quiet) : quiet_(quiet) {}

    StudyWatch watch() {
        return {[this](std::size_t done, std::size_t all) {
                    if (done == 0) progress_.emplace(all, quiet_ ? ProgressWay::none : ProgressWay::automatic);
                    progress_->show(done);
                    if (done == all) progress_->clear();
                },
                [this](const Phrase& problem) { progress_->say_line(phrase("tactics: {0}", problem)); }};
    }

private:
    bool quiet_;
    std::optional<Progress> progress_;
};

// The last words, "2 could not be scored:" and which. Gives the exit code.
int tell_problems(const StudyFindings& findings) {
    if (findings.problems.empty()) return 0;
    say(phrase(findings.undone, std::to_string(findings.problems.size())));
    for (const Phrase& problem : findings.problems) say("  " + problem.in(user_language()));
    return static_cast<int>(Fault::failed);
}

void give_out_charts(const StudyFindings& findings, const std::vector<ChartFile>& asked) {
    if (asked.empty()) return;
    for (const StudyChart& chart : findings.charts) {
        if (!chart.missing.empty()) {
            say(chart.missing);
            continue;
        }
        std::vector<ChartFile> files = asked;
        if (!chart.word.empty())
            for (ChartFile& file : files) file.path = with_word(file.path, chart.word);
        write_charts(chart.plot, files);
    }
}

int run_evaluate(const Given& given) {
    const EvaluateRequest request = plan_evaluation(given, real_disk());
    Telling telling(request.quiet);
    const StudyFindings findings = request.study->run(request, telling.watch());
    if (request.csv != "-") print_out(request.json ? findings.json : findings.text);
    if (!request.csv.empty()) write_file(request.csv, findings.csv);
    if (!request.quiet)
        for (const auto& remark : findings.remarks) say(remark);
    const int code = tell_problems(findings);
    give_out_charts(findings, request.chart_files);
    return code;
}

}  // namespace

extern const Command evaluate_command;
const Command evaluate_command{
    .name = "evaluate",
    .summary = "score recipes against contours that people drew of the same pictures",
    .words = "FOLDER",
    .details = details(),
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
    .flags = flags(),
    .offers = "folders",
    .run = run_evaluate,
};

}  // namespace tactics
