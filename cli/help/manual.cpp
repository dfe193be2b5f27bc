// SPDX-License-Identifier: Apache-2.0
#include "cli/help/manual.h"

#include "cli/command.h"
#include "cli/help/catalogue.h"
#include "cli/help/thing_texts.h"

namespace tactics {

namespace {

// Text that roff shows as it is: a hyphen that can be copied, no control line.
std::string plain(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        const bool starts_line = safe.empty() || safe.back() == '\n';
        if (starts_line && (c == '.' || c == '\'')) safe += "\\&";
        if (c == '\\')
            safe += "\\e";
        else if (c == '-')
            safe += "\\-";
        else
            safe += c;
    }
    return safe;
}

std::string section(std::string_view name) { return ".SH " + std::string(name) + "\n"; }
std::string bold(std::string_view text) { return "\\fB" + plain(text) + "\\fP"; }
std::string item(std::string_view name, std::string_view text) { return ".TP\n" + bold(name) + "\n" + plain(text) + "\n"; }

std::string paragraphs(std::string_view text) {
    std::string roff;
    while (!text.empty()) {
        const auto end = text.find("\n\n");
        roff += ".PP\n" + plain(text.substr(0, end)) + "\n";
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 2);
    }
    return roff;
}

std::string literal(std::string_view text) { return ".PP\n.RS 4\n.nf\n" + plain(text) + "\n.fi\n.RE\n"; }

std::string settings(std::span<const Option> options) {
    if (options.empty()) return "";
    std::string roff = ".RS\n";
    for (const Option& option : options)
        roff += item(spelling(option), std::string(option.summary) + " (" + describe_range(option) + ")");
    return roff + ".RE\n";
}

std::string commands_part() {
    std::string roff = section("COMMANDS");
    for (const Command* command : commands()) {
        roff += ".SS " + std::string(command->name) + "\n" + bold("tactics " + std::string(command->name)) + " " +
                plain(command->words) + "\n" +
                paragraphs(std::string(command->summary) + ".\n\n" + std::string(command->details));
        for (const Flag& flag : all_flags(*command)) roff += item(spelling(flag), flag.summary);
        roff += literal(command->example);
    }
    return roff;
}

std::string group_part(const Group& group) {
    std::string heading(group.name);
    for (char& c : heading) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    std::string roff = section(heading);
    for (const Entry& entry : group.entries())
        roff += item(entry.name, entry.summary) + (group.settings == Group::Settings::in_manual ? settings(entry.options) : "") +
                (group.text_in_manual ? literal(entry.text()) : "");
    return roff;
}

}  // namespace

std::string manual() {
    std::string roff =
        ".TH TACTICS 1 \"\" \"tactics " TACTICS_VERSION "\" \"User Commands\"\n" + section("NAME") +
        "tactics \\- tactile graphics from pictures\n" + section("SYNOPSIS") + bold("tactics") + " COMMAND [WORDS] [OPTIONS]\n" +
        section("DESCRIPTION") +
        plain(
            "From photographs and other pictures tactics makes line drawings that can be felt: for microcapsule paper, "
            "thermoform, braille embossers and height maps.\n");
    roff += commands_part();
    for (const Group& group : groups())
        if (!group.begins_with_text && !group.installed) roff += group_part(group);
    roff += section("EXIT STATUS") + item("0", "done") + item("1", "wrong use of the command line or of a recipe") +
            item("2", "something could not be done; in a batch the rest is written") +
            item("3", "done, but --strict found a hard rule broken");
    return roff;
}

}  // namespace tactics
