// SPDX-License-Identifier: Apache-2.0
// `tactics help`: the descriptions, as text or as man pages.
#include "cli/command.h"
#include "cli/help/describe.h"
#include "cli/help/manual.h"
#include "cli/report/say.h"
#include "cli/report/wrapped_help.h"
#include "tactics/error.h"
#include "tactics/transport/file.h"

namespace tactics {

namespace {

constexpr Flag kHelpFlags[] = {
    {"--man", "", "", "write a man page (roff), for the command that you name or for tactics(1)", false, ""},
    {"--man-pages", "", "FOLDER",
     "write all man pages into a folder: tactics.1 and one for each command, such as tactics-convert.1", false, "folders"},
};

std::string man_page(const std::vector<std::string>& words) {
    if (words.empty()) return manual();
    const Command* command = words.size() == 1 ? find_command(words[0]) : nullptr;
    if (command == nullptr)
        throw Error(Fault::usage, "--man",
                    phrase("only commands have man pages of their own; name one command, or none for tactics(1)"));
    return manual_of(*command);
}

void write_man_pages(const Given& given) {
    const std::string folder = given.value("--man-pages");
    if (given.has("--man") || !given.words.empty())
        throw Error(Fault::usage, "--man-pages", phrase("it writes all pages; leave out --man and any names"));
    write_file(folder + "/tactics.1", manual());
    for (const Command* command : commands())
        write_file(folder + "/tactics-" + std::string(command->name) + ".1", manual_of(*command));
}

int run_help(const Given& given) {
    if (given.has("--man-pages")) {
        write_man_pages(given);
        return 0;
    }
    std::string text;
    if (given.has("--man"))
        text = man_page(given.words);
    else if (given.words.empty())
        text = describe_program();
    else
        for (const auto& word : given.words) text += (text.empty() ? "" : "\n") + describe_topic(word);
    if (given.has("--man"))
        print_out(text);
    else
        print_help(text);
    return 0;
}

}  // namespace

extern const Command help_command;
const Command help_command{
    .name = "help",
    .summary = "explain a command, recipe, filter, format, medium, paper, braille table, reader, rule or topic",
    .words = "[NAME...]",
    .details = "A name that stands in several lists is explained in each: sobel may be a filter and a recipe.",
    .example =
        "tactics help convert\ntactics help sobel\ntactics help mouse\ntactics help --man convert > tactics-convert.1\ntactics "
        "help --man-pages man/",
    .flags = kHelpFlags,
    .offers = "commands recipes filters formats media papers cells rules topics",
    .run = run_help,
};

}  // namespace tactics
