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
};

constexpr Flag kAfterStudies[] = {
    {"--paper", "-p", "PAPER",
     "paper that the drawing would be printed on, which says how large it is; that of pdf if none is named", false, "papers"},
    {"--medium", "-m", "MEDIUM", "what it would be printed on; that of pdf if none is named", false, "media"},
    {"--margin", "", "LENGTH", "margin on every side; the medium's own if none is named", false, ""},
    kAllowFlag,
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
             kept("another question than F, see below; " + joined(without_maps, ", ", " and ") + " need no contour maps"), false,
             kept(joined(names, " ", " "))});
        for (const Study* study : studies())
            for (const Option& option : study->options)
                all.push_back({kept("--" + std::string(option.name)), "", "NUMBER",
                               kept("of --study " + std::string(study->name) + ": " + std::string(option.summary) + "; " +
                                    to_text(option.fallback) + " if none is named"),
                               false, ""});
        all.insert(all.end(), std::begin(kAfterStudies), std::end(kAfterStudies));
        return all;
    }();
    return kFlags;
}

constexpr std::string_view kDetails =
    "FOLDER holds pictures in images/ and, in gt/, the contour maps that people drew of them: NAME_gt1.png, NAME_gt2.png and "
    "so on for picture NAME, of the same size, white lines on black. Without images/ the pictures are in FOLDER itself; "
    "--truth names another place for the maps. A figure (SVG), a table or a model among them is drawn as convert draws it, "
    "stretched over its maps and scored beside the rest: so a page drawn by hand is measured, too.\n\n"
    "Scores are those of the Berkeley benchmark: lines are thinned to one pixel and matched one to one with each person's "
    "pixels within 0.75 percent of the diagonal. P (precision) is the share of the lines that anybody drew, R (recall) the "
    "share of what all of them drew that was found, F their harmonic mean. F, P and R are at the dial that is best for all "
    "pictures together (ODS); OIS F lets each picture have its own. The row people scores each person against the others, the "
    "row simplest person the one whose map of a picture has the fewest regions.\n\n"
    "The dial is the strength below which lines are left out, where a recipe gives strengths, and the value of --sweep. "
    "Scored are the strokes and the outlines of areas of a drawing; of an edge map all pixels as strong as the dial says; of "
    "a picture the borders between parts of different value. An edge map is not cut before it is scored.\n\n"
    "Line mm and strokes are means of a drawing as the recipe makes it; crowded is the share of its line that runs closer to "
    "another line than the medium's gap. CPU ms is the median time of a picture for the recipe alone, then with choosing and "
    "reading. Nothing counts the pictures on which no line was drawn; they are scored.\n\n";
constexpr std::string_view kEndOfDetails =
    "What cannot be scored is named and left out, the rest is reported, and the exit code is 2.";

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
                [this](const std::string& problem) { progress_->say_line("tactics: " + problem); }};
    }

private:
    bool quiet_;
    std::optional<Progress> progress_;
};

// The last words, "2 could not be scored:" and which. Gives the exit code.
int tell_problems(const StudyFindings& findings) {
    if (findings.problems.empty()) return 0;
    say(std::to_string(findings.problems.size()) + " could not be " + std::string(findings.undone) + ":");
    for (const auto& problem : findings.problems) say("  " + problem);
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

int run(const Given& given) {
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
    .run = run,
};

}  // namespace tactics
