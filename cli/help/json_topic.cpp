// SPDX-License-Identifier: Apache-2.0
// `tactics help json`: the output of --json, for programs that read it.
#include "cli/command.h"
#include "cli/help/topics.h"
#include "tactics/text/json.h"

namespace tactics {

namespace {

// What play and evaluate print changes with what is studied.
bool promises(const Command& command) {
    if (command.name == "play" || command.name == "evaluate") return false;
    for (const Flag& flag : command.flags)
        if (flag.name == "--json") return true;
    return false;
}

std::string json_topic_text() {
    std::string text =
        "With --json a command writes JSON objects to standard output, one per line (JSON\n"
        "Lines), in UTF-8, each as soon as it is ready, and nothing else. Messages for\n"
        "people still go to standard error. The exit code does not change.\n"
        "\n"
        "The first member of each object is \"schema\", the version of its format, now " +
        std::to_string(JsonAnswer::kSchema) +
        ".\n"
        "A JSON Schema (2020-12) for each command is installed under the prefix:\n";
    for (const Command* command : commands())
        if (promises(*command)) text += "  share/tactics/schemas/" + std::string(command->name) + ".schema.json\n";
    return text +
           "New members may appear without a new version, so ignore members you do not know.\n"
           "Removing or renaming a member, or changing what it means, raises the version. The\n"
           "output of play and evaluate has no version and may change at any time.\n"
           "\n"
           "Members that end in _mm are lengths in mm; places are measured from the upper\n"
           "left. Names are those of tactics list. Sentences (notes, warnings, reason, error)\n"
           "are for people and may change at any time. The language and the locale change\n"
           "nothing else. A byte of a file name that is not UTF-8 appears as a lone surrogate,\n"
           "\\udc80 for 80h, as in Python's surrogateescape.\n"
           "\n"
           "Example:\n"
           "  tactics convert photos/*.jpg -o pages/ --json |\n"
           "    jq -r 'select(.warnings) | .input'\n";
}

}  // namespace

extern const Topic json_topic;
const Topic json_topic{
    .name = "json",
    .summary = "the output of --json, for programs that read it",
    .text = json_topic_text,
};

}  // namespace tactics
