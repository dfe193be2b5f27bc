// SPDX-License-Identifier: Apache-2.0
// `tactics help`: the descriptions, as text or as the man page.
#include "cli/command.h"
#include "cli/help/describe.h"
#include "cli/help/manual.h"
#include "cli/report/say.h"
#include "cli/report/wrapped_help.h"

namespace tactics {

namespace {

constexpr Flag kFlags[] = {
    {"--man", "", "", "write the whole help as a man page (roff)", false, ""},
};

int run(const Given& given) {
    std::string text;
    if (given.has("--man"))
        text = manual();
    else if (given.words.empty())
        text = describe_program();
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
    .summary = "explain a command, recipe, filter, format, medium, paper, table of braille, reader, rule or topic",
    .words = "[NAME...]",
    .details = "A name that stands in several lists is explained in each: sobel may be a filter and a recipe.",
    .example = "tactics help convert\ntactics help sobel\ntactics help mouse\ntactics help --man > tactics.1",
    .flags = kFlags,
    .offers = "commands recipes filters formats media papers cells rules topics",
    .run = run,
};

}  // namespace tactics
