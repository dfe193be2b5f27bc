// SPDX-License-Identifier: Apache-2.0
#include "cli/help/manual.h"

#include <algorithm>

#include "cli/command.h"
#include "cli/help/catalogue.h"
#include "cli/help/thing_texts.h"

namespace tactics {

namespace {

// Text that roff shows unchanged: a hyphen that can be copied, no control line.
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

// Of the page of that name: "tactics-convert(1)".
std::string reference(std::string_view command) { return bold("tactics-" + std::string(command)) + "(1)"; }

std::string head(std::string_view name, std::string_view summary) {
    std::string title(name);
    for (char& c : title) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    return ".TH " + plain(title) + " 1 \"\" \"tactics " TACTICS_VERSION "\" \"User Commands\"\n" + section("NAME") + plain(name) +
           " \\- " + plain(summary) + "\n" + section("SYNOPSIS");
}

std::string commands_part() {
    std::string roff = section("COMMANDS") + paragraphs("Each command has its own manual page.");
    for (const Command* command : commands()) roff += ".TP\n" + reference(command->name) + "\n" + plain(command->summary) + "\n";
    return roff;
}

std::string exit_part(bool strict) {
    return section("EXIT STATUS") + item("0", "done") + item("1", "wrong use of the command line or of a recipe") +
           item("2", "something could not be done; in a batch, the rest is written") +
           (strict ? item("3", "done, but --strict found a hard rule broken") : "");
}

std::string environment_part() {
    return section("ENVIRONMENT") +
           item("LANGUAGE, LC_ALL, LC_MESSAGES, LANG",
                "language of messages, reports and the help of commands (--help): German (de), French (fr), else English; manual "
                "pages and lists are in English") +
           item("TACTICS_NETS", "folder with the weights of the contour net, searched before the installed one") +
           item("TACTICS_PROGRAMS",
                "folder of the programs that read untrusted files for tactics, searched before the installed one") +
           item("TMPDIR", "folder for temporary files; /tmp by default, then /var/tmp and XDG_RUNTIME_DIR if /tmp takes none") +
           item("NO_COLOR, TERM", "progress is never shown as a bar if NO_COLOR is set or TERM is dumb") +
           item("LOUIS_TABLEPATH", "folders with your own braille tables, separated by commas") +
           item("XDG_STATE_HOME", "folder where play stores what it learns about a device; ~/.local/state by default");
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
        head("tactics", "tactile graphics from pictures") + bold("tactics") + " COMMAND [WORDS] [OPTIONS]\n" +
        section("DESCRIPTION") +
        plain(
            "tactics turns photographs and other pictures into line drawings to be read by touch: on microcapsule paper, "
            "thermoform, braille embossers and height maps.\n");
    roff += commands_part();
    for (const Group& group : groups())
        if (!group.begins_with_text && !group.installed) roff += group_part(group);
    return roff + exit_part(true) + environment_part();
}

std::string manual_of(const Command& command) {
    std::string roff = head("tactics-" + std::string(command.name), command.summary) +
                       bold("tactics " + std::string(command.name)) + (command.words.empty() ? "" : " ") + plain(command.words) +
                       (command.flags.empty() ? "" : " [OPTIONS]") + "\n" + section("DESCRIPTION") + paragraphs(command.details) +
                       section("OPTIONS");
    const bool strict =
        std::any_of(command.flags.begin(), command.flags.end(), [](const Flag& flag) { return flag.name == "--strict"; });
    for (const Flag& flag : all_flags(command)) roff += item(spelling(flag), flag.summary);
    roff += section("EXAMPLES") + literal(command.example) + exit_part(strict);
    return roff + section("SEE ALSO") + bold("tactics") + "(1), " + plain("to list recipes, filters, formats and rules") + "\n";
}

}  // namespace tactics
