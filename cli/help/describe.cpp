// SPDX-License-Identifier: Apache-2.0
#include "cli/help/describe.h"

#include "cli/help/catalogue.h"
#include "cli/help/help_language.h"
#include "cli/help/thing_texts.h"
#include "cli/report/user_language.h"
#include "print/embosser.h"
#include "tactics/error.h"

namespace tactics {

std::string describe_program() {
    std::vector<std::string> summaries;
    for (const Command* command : commands()) summaries.emplace_back(command->summary);
    const std::string_view language = language_of_help(summaries, user_language());
    const auto said = [&](const Phrase& line) { return line.in(language) + "\n"; };
    std::string text = said(phrase("tactics: tactile graphics from pictures")) + "\n" +
                       said(phrase("Use: tactics {0}", "COMMAND [WORDS] [OPTIONS]")) + "\n" + said(phrase("Example:")) +
                       "  tactics convert photo.jpg -o photo.pdf\n\n" + said(phrase("Commands:"));
    for (const Command* command : commands())
        text += "  " + said(phrase("{0}: {1}", command->name, help_text(command->summary, language)));
    return text + "\n" + said(phrase("Options:")) + " " + said(phrase("{0}: {1}", "-h, --help", phrase("show this text"))) + " " +
           said(phrase("{0}: {1}", "-V, --version", phrase("show the version"))) + "\n" +
           said(phrase(
               "More: tactics help NAME, for any command, recipe, filter, format, medium, paper, rule or topic; tactics list "
               "shows their names.")) +
           said(phrase("Exit codes: 0 done, 1 wrong use, 2 something could not be done, 3 done, but --strict found a hard rule "
                       "broken; 4 to 7 come from emboss, see its help."));
}

std::string describe_topic(std::string_view name) {
    std::string text;
    std::vector<std::string_view> names;
    for (const Group& group : groups()) {
        names.push_back(group.name);
        for (const Entry& entry : all_entries(group)) {
            names.push_back(entry.name);
            if (entry.name != name) continue;
            if (!text.empty()) text += "\n";
            if (!group.begins_with_text)
                text += std::string(group.singular) + " " + std::string(name) + ": " + std::string(entry.summary) + "\n";
            text += entry.text();
        }
    }
    if (const Format* format = text.empty() ? find_model(name) : nullptr)
        return driven_as(name, *format).english() + ".\n\n" + describe_topic(format->name);
    if (text.empty())
        throw Error(Fault::usage, "",
                    phrase("there is no help on \"{0}\"{1}; see tactics list", name.substr(0, 80), did_you_mean(name, names)));
    return text;
}

}  // namespace tactics
