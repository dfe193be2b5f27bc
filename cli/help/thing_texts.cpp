// SPDX-License-Identifier: Apache-2.0
#include "cli/help/thing_texts.h"

#include <algorithm>

#include "cli/help/help_language.h"
#include "cli/report/user_language.h"
#include "tactics/error.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string describe_options(std::span<const Option> options) {
    if (options.empty()) return "It has no settings.\n";
    std::string text = "Settings:\n";
    for (const Option& option : options)
        text += "  " + spelling(option) + ": " + std::string(option.summary) + " (" + describe_range(option) + ")\n";
    return text;
}

std::string kinds_text(Kinds kinds) {
    std::string text;
    for (const Kind kind : {Kind::picture, Kind::edges, Kind::regions, Kind::drawing})
        if (contains(kinds, kind))
            text += (text.empty() ? "" : " or ") + std::string(kind == Kind::edges ? "an " : "a ") + std::string(name_of(kind));
    return text;
}

// An option as it could be typed, with its default: a whole example must parse.
std::string example_setting(const Option& option) {
    Settings settings({&option, 1});
    if (option.type == Option::Type::spots) return std::string(option.name) + "=20%,30%-70%,90%";
    const std::string text =
        option.type == Option::Type::choice ? std::string(settings.choice(option.name)) : to_text(settings.number(option.name));
    return std::string(option.name) + "=" + text + (option.type == Option::Type::length ? "mm" : "");
}

std::string where_dots_are(const Format& format) {
    const auto mm = [](double value) { return to_text(value) + " mm"; };
    if (format.dots == nullptr) return "Dots stand anywhere.";
    const DotSetting set = format.dots(Settings(format.options));
    if (set.width > 0) return "Pins stand " + mm(set.bed.raster) + " apart, on " + mm(set.width) + " by " + mm(set.height) + ".";
    if (set.bed.raster > 0) return "Dots stand " + mm(set.bed.raster) + " apart all over the sheet.";
    return "Dots stand in its cells only, " + mm(set.cell.dot_pitch) + " apart; cells " + mm(set.cell.cell_pitch) + ", lines " +
           mm(set.cell.line_pitch) + ".";
}

}  // namespace

std::string indent(std::string_view text) {
    std::string indented;
    while (!text.empty()) {
        const auto end = text.find('\n');
        indented += "  " + std::string(text.substr(0, end)) + "\n";
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    }
    return indented;
}

std::string describe_filter(const Filter& filter) {
    std::string text = "It takes " + kinds_text(filter.takes) + " and gives ";
    text += filter.gives == 0 ? "the same kind" : kinds_text(filter.gives);
    text += filter.uses_colour ? "; it uses colour.\n" : ".\n";
    text += describe_options(filter.options);
    const std::string setting = filter.options.empty() ? "" : " " + example_setting(filter.options[0]);
    return text + "Example: --filter \"" + std::string(filter.name) + setting + "\"\n";
}

std::string describe_recipe(const NamedRecipe& recipe) {
    return "Its filters, as a recipe file would hold them:\n" + indent(recipe.text) +
           "Example: tactics convert photo.jpg -o photo.pdf --recipe " + std::string(recipe.name) + "\n";
}

std::string describe_format(const Format& format) {
    const auto extensions = words_of(format.extensions);
    std::string endings;
    for (const auto extension : extensions) endings += (endings.empty() ? "." : ", .") + std::string(extension);
    std::string text = "File names end in " + endings + ". By default it is made for medium " + std::string(format.medium) +
                       " and paper " + std::string(format.paper) + ".\n";
    text += describe_options(format.options);
    return text + "Example: tactics convert photo.jpg -o page." + std::string(extensions.empty() ? format.name : extensions[0]) +
           "\n";
}

std::string describe_embosser(const Format& format) {
    const Embosser& embosser = *format.embosser;
    const auto mm = [](double value) { return to_text(value) + " mm"; };
    std::string text = "Machines: " + std::string(embosser.models) + ".\n";
    if (embosser.widest > 0)
        text += "It takes sheets up to " + mm(embosser.widest) + " wide" +
                (embosser.longest > 0 ? " and " + mm(embosser.longest) + " long" : "") + ".\n";
    if (!embosser.called.empty())
        text += "These names also mean " + std::string(format.name) + ": " + std::string(embosser.called) + ".\n";
    text += where_dots_are(format);
    text += "\n" + describe_options(format.options) +
            "Sources of its bytes (this project has not tried any of them on the machine):\n";
    for (const ProtocolFact& fact : embosser.facts)
        text += "  " + std::string(name_of(fact.confidence)) + ": " + std::string(fact.fact) + " (" + std::string(fact.source) +
                ")\n";
    const std::string name(format.name);
    if (embosser.display != nullptr) return text + "Example: tactics show photo.jpg --on " + name + ":/dev/ttyUSB0\n";
    return text + "Example: tactics convert photo.jpg -o " + name + ":page.prn; tactics preview page.prn --embosser " + name +
           "\n";
}

std::string describe_braille_table(const BrailleTable& table) {
    return (table.type.empty() ? "" : "Its type is " + table.type + ". ") +
           (table.dots.empty() ? "" : "Cells have " + table.dots + " dots. ") +
           "It comes with liblouis.\nExample: tactics convert photo.jpg -o page.pdf --title Title --braille " + table.name + "\n";
}

std::string describe_medium(const Medium& medium) {
    const auto mm = [](double value) { return to_text(value) + " mm"; };
    return "Lines are " + mm(medium.thin_line) + " (thin), " + mm(medium.line) + " (normal) or " + mm(medium.thick_line) +
           " (thick) wide, at least " + mm(medium.gap) + " apart and " + mm(medium.shortest) + " long. The margin is " +
           mm(medium.margin) + " by default.\nExample: tactics convert photo.jpg -o page.pdf --medium " +
           std::string(medium.name) + "\n";
}

std::string describe_paper(const Paper& paper) {
    return to_text(paper.width) + " x " + to_text(paper.height) +
           " mm upright. You can give any other size in numbers, such as 200x150mm or 8.5x11in.\n"
           "Example: tactics convert photo.jpg -o page.pdf --paper " +
           std::string(paper.name) + "\n";
}

std::string describe_rule(const Rule& rule) {
    std::string text = rule.hard ? "It is a hard rule: a page that breaks it is not fit for use.\n"
                                 : "It is not a hard rule: where a page breaks it, a person should look.\n";
    text +=
        "Limit:\n  " + spelling(rule.limit) + ": " + std::string(rule.limit.summary) + " (" + describe_range(rule.limit) + ")\n";
    std::string limits;
    std::string_view example;
    for (const Medium& medium : media()) {
        const auto limit = limit_of(rule, medium);
        if (limit && example.empty()) example = medium.name;
        limits += (limits.empty() ? "" : ", ") + std::string(medium.name) + " " + (limit ? to_text(*limit) : "none");
    }
    text += "By medium: " + limits + ".\nWhat to do: " + std::string(rule.mend.text) + ".\nSource: " + std::string(rule.source) +
            ".\nConfidence in the number: " + std::string(name_of(rule.confidence)) + ".";
    if (rule.confidence != Confidence::good) text += " Treat it as a hint, and change it if your readers prefer otherwise.";
    return text + "\nExample: tactics check page.svg --rule " + std::string(rule.name) + " --medium " + std::string(example) +
           " --set " + std::string(rule.name) + "." + example_setting(rule.limit) + "\n";
}

std::string describe_cell(const NamedCell& cell) {
    const CellSize& size = cell.size;
    return "Dots " + to_text(size.dot) + " mm wide stand " + to_text(size.dot_pitch) + " mm apart, cells " +
           to_text(size.cell_pitch) + " mm, lines " + to_text(size.line_pitch) +
           " mm.\nExample: tactics convert photo.jpg -o page.pdf --title Heart --cell " + std::string(cell.name) + "\n";
}

std::string explain_command(const Command& command) {
    const std::string_view language = language_of_help(help_texts(command), user_language());
    const auto said = [&](const Phrase& line) { return line.in(language) + "\n"; };
    const std::string use = std::string(command.name) + (command.words.empty() ? "" : " ") + std::string(command.words);
    std::string text = said(phrase("tactics {0}: {1}", command.name, help_text(command.summary, language))) + "\n" +
                       said(phrase("Use: tactics {0}", use)) + "\n";
    for (std::string_view rest = command.details; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        text += (line.empty() ? "" : help_text(line, language)) + "\n";
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    }
    text += "\n" + said(phrase("Options:"));
    for (const Flag& flag : all_flags(command))
        text += "  " + said(phrase("{0}: {1}", spelling(flag), help_text(flag.summary, language)));
    return text + "\n" + said(phrase("Examples:")) + indent(command.example);
}

std::string spelling(const Flag& flag) {
    std::string text = flag.letter.empty() ? "" : std::string(flag.letter) + ", ";
    text += flag.name;
    return flag.value.empty() ? text : text + " " + std::string(flag.value);
}

std::string spelling(const Option& option) {
    std::string_view value = "NUMBER";
    if (option.type == Option::Type::length) value = "LENGTH";
    if (option.type == Option::Type::choice) value = "NAME";
    if (option.type == Option::Type::spots) value = "PLACES";
    if (option.type == Option::Type::words) value = "WORDS";
    if (option.type == Option::Type::date) value = "DATE";
    return std::string(option.name) + "=" + std::string(value);
}

}  // namespace tactics
