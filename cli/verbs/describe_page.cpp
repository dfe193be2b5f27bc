// SPDX-License-Identifier: Apache-2.0
// `tactics describe`: what would be on the page of a picture, in words.
#include <algorithm>

#include "cli/batch.h"
#include "cli/command.h"
#include "cli/model_flags.h"
#include "cli/outputs.h"
#include "cli/page_flags.h"
#include "cli/table_flags.h"
#include "tactics/description/description.h"
#include "tactics/description/description_json.h"
#include "tactics/error.h"
#include "tactics/job/make_pages.h"
#include "tactics/text/json.h"

namespace tactics {

namespace {

constexpr Flag kDescribePageFlags[] = {
    {"--output", "-o", "FILE", "write the description to this text file instead of standard output", false, "files"},
    kPdfPageFlag,
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
     "change a setting in every step of a filter, such as sobel.blur=0.5mm. May be given several times", true, "settings"},
    kDetailFlag,
    kAsDrawnFlag,
    {"--paper", "-p", "PAPER", "paper of the page: a name or a size such as 200x150mm; default: a4", false, "papers"},
    {"--medium", "-m", "MEDIUM", "what the page would be made on; default: swell", false, "media"},
    {"--embosser", "", "NAME", "describe the page as this machine of tactics list embossers gets it, with its dots and heights",
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
    kLanguageFlag,
    kCellFlag,
    kSubjectFlag,
    kSubjectOnlyFlag,
    kLeaveFlag,
    kLabelFlag,
    kLabelsFlag,
    kBareFlag,
    kJobsFlag,
    {"--json", "", "", "one JSON object for each picture, with sizes and places in mm", false, ""},
};

std::string text_of_describe_page(const Outcome& outcome) {
    std::string text;
    for (const Page& page : outcome.layouts.front().shown) {
        if (!text.empty()) text += "\n";
        for (const std::string& line : lines_of(describe(page))) text += line + "\n";
    }
    // The differences between the page and the recipe's drawing, as in a transcriber's note.
    const MendingTold& mended = outcome.layouts.front().mended;
    const std::string& language = outcome.layouts.front().sheet.language;
    if (!mended.notes.empty()) text += phrase("Changed to be felt:").in(language) + "\n";
    for (const Phrase& note : mended.notes) text += note.in(language) + "\n";
    return text;
}

// The description of one picture; errors go to standard error.
std::string alone(const Outcome& outcome) { return outcome.error.empty() ? text_of_describe_page(outcome) : ""; }

// For several pictures: below its name, followed by an empty line.
std::string among_others(const Outcome& outcome) {
    return outcome.error.empty() ? outcome.input + ":\n" + text_of_describe_page(outcome) + "\n" : "";
}

std::string describe_page_in_json(const Outcome& outcome) {
    JsonAnswer json;
    json.add("input", outcome.input);
    if (!outcome.error.empty()) {
        json.add("error", outcome.error.english());
        return json.text() + "\n";
    }
    json.add("recipe", outcome.recipe);
    add_description(json, outcome.layouts.front().shown);
    if (!outcome.model_json.empty()) json.add_raw("model", outcome.model_json);
    return json.text() + "\n";
}

std::vector<Item> plan_items(const Given& given) {
    if (given.words.empty())
        throw Error(Fault::usage, "describe", phrase("no picture is named; for example: tactics describe photo.jpg"));
    if (std::count(given.words.begin(), given.words.end(), "-") > 1)
        throw Error(Fault::usage, "describe", phrase("standard input (-) is named twice; it can be read once"));
    const Format* text = find_format("text");
    if (!given.has("--output")) {
        std::vector<Item> items;
        for (const std::string& input : given.words) items.push_back({input, {{text, "", ""}}});
        return items;
    }
    if (given.has("--json"))
        throw Error(Fault::usage, "--json",
                    phrase("it goes to standard output; leave out -o, and write > FILE behind the command"));
    std::string out = given.value("--output");
    if (out == "-") out = "text:-";
    std::vector<Item> items = plan_outputs(given.words, {out}, {}, real_disk());
    if (items.front().outputs.front().format != text)
        throw Error(Fault::usage, "-o " + out,
                    phrase("a description is plain text; end the name in .txt, or use tactics convert, which also fills folders: "
                           "--to text"));
    if (items.size() > 1)
        throw Error(Fault::usage, "-o " + out,
                    phrase("it takes the description of one picture; leave out -o, and write > FILE behind the command"));
    return items;
}

int run_describe_page(const Given& given) {
    Request request = plan_pages(plan_items(given), given, real_disk());
    const Output& output = request.items.front().outputs.front();
    request.loudness = output.path.empty() ? Loudness::errors : Loudness::usual;
    if (given.has("--json"))
        request.answer = describe_page_in_json;
    else if (output.path.empty())
        request.answer = request.items.size() > 1 ? among_others : alone;
    return run_batch(request);
}

}  // namespace

extern const Command describe_command;
const Command describe_command{
    .name = "describe",
    .summary = "describe in words what is on a picture's page and where",
    .words = "INPUT... [-o FILE.txt]",
    .details =
        "The description gives the size of the page, how much is on it, and the main lines and areas from top to bottom: how "
        "each feels to a finger, how long or wide it is, and in which ninth of the drawing it lies. It does not guess what is "
        "depicted. The page is the one that tactics convert makes with the same options. The description of a model names its "
        "parts: where each lies, what was done with it, and which are not drawn; tactics help model lists the members of "
        "--json.\n\n"
        "The same description is the alternative text of pdf, svg and ebrl, unless you give your own with tactics convert "
        "--describe.",
    .example =
        "tactics describe photo.jpg\n"
        "tactics describe photo.jpg --paper letter --title \"Hot air balloon\"\n"
        "tactics describe photos/*.jpg > words.txt\n"
        "tactics convert photos/*.jpg -o words/ --to text\n"
        "tactics describe photo.jpg --json",
    .flags = kDescribePageFlags,
    .offers = "files",
    .takes_kept = true,
    .run = run_describe_page,
};

}  // namespace tactics
