// SPDX-License-Identifier: Apache-2.0
// `tactics help json`: what programs may count on that read our answers.
#include "cli/command.h"
#include "cli/help/topics.h"
#include "tactics/text/json.h"

namespace tactics {

namespace {

// Figures of a simulation and of an experiment follow what is asked there, and promise nothing.
bool promises(const Command& command) {
    if (command.name == "play" || command.name == "evaluate") return false;
    for (const Flag& flag : command.flags)
        if (flag.name == "--json") return true;
    return false;
}

std::string text() {
    std::string text =
        "With --json a command answers a program: objects on standard output, one a line\n"
        "(JSON Lines), in UTF-8, as they are done. Nothing else is written there; what is\n"
        "told to a person goes to standard error as before. The exit code is the same.\n"
        "\n"
        "The first member of each object is \"schema\", the version of what it promises: " +
        std::to_string(JsonAnswer::kSchema) +
        ".\n"
        "JSON Schemas (2020-12) of it are installed under the prefix, a file a command:\n";
    for (const Command* command : commands())
        if (promises(*command)) text += "  share/tactics/schemas/" + std::string(command->name) + ".schema.json\n";
    return text +
           "In the same version members may be added, so leave alone what you do not know. A\n"
           "member that goes, gets another name or means something else raises the version.\n"
           "The figures of play and evaluate have no version: they may change at any time.\n"
           "\n"
           "Lengths are mm, in members that end in _mm; places are from the upper left. Names\n"
           "are those that the lists have. Sentences (notes, warnings, reason, error) are for\n"
           "people and may change at any time. Neither the language nor the locale changes\n"
           "anything else. A byte of a file's name that is not UTF-8 stands as a lone\n"
           "surrogate, \\udc80 for 80h, as Python's surrogateescape has it.\n"
           "\n"
           "Example:\n"
           "  tactics convert photos/*.jpg -o pages/ --json |\n"
           "    jq -r 'select(.warnings) | .input'\n";
}

}  // namespace

extern const Topic json_topic;
const Topic json_topic{
    .name = "json",
    .summary = "what programs may count on that read --json",
    .text = text,
};

}  // namespace tactics
