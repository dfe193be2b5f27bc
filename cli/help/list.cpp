// SPDX-License-Identifier: Apache-2.0
// `tactics list`: the names of everything.

#include "cli/command.h"
#include "cli/help/catalogue.h"
#include "cli/report/say.h"
#include "cli/report/wrapped_help.h"
#include "tactics/braille/tables.h"
#include "tactics/error.h"
#include "tactics/text/json.h"

namespace tactics {

namespace {

constexpr Flag kListFlags[] = {
    {"--json", "", "", "one JSON object per line: group, name, summary, settings", false, ""},
};

std::string options_json(std::span<const Option> options) {
    std::vector<std::string> all;
    for (const Option& option : options) {
        JsonObject json;
        json.add("name", option.name);
        json.add("summary", option.summary);
        if (option.type == Option::Type::choice) {
            std::vector<std::string> names;
            for (const auto name : choice_names(option)) names.push_back(json_text(name));
            json.add_raw("choices", json_array(names));
            json.add("default", choice_names(option)[static_cast<std::size_t>(option.fallback)]);
        } else if (option.type == Option::Type::spots || option.type == Option::Type::words ||
                   option.type == Option::Type::date) {
            json.add("default", "");
        } else {
            json.add("min", option.min);
            json.add("max", option.max);
            json.add("default", option.fallback);
            json.add("unit", option.unit);
        }
        all.push_back(json.text());
    }
    return json_array(all);
}

std::string entry_json(const Group& group, const Entry& entry) {
    JsonAnswer json;
    json.add("group", group.name);
    json.add("name", entry.name);
    json.add("summary", entry.summary);
    if (group.settings != Group::Settings::none) json.add_raw("settings", options_json(entry.options));
    if (entry.json) entry.json(json);
    return json.text() + "\n";
}

struct Wanted {
    const Group* group = nullptr;
    std::vector<std::string> only = {};  // names of entries; empty: all
};

// "de" or "german" after the group braille: the tables of that language, the usual one first.
void take_language(Wanted& braille, const std::string& language) {
    const std::vector<BrailleTable> tables = tables_for(language, described_tables());
    if (tables.empty())
        throw Error(Fault::usage, "list braille",
                    phrase("there is no table for the language \"{0}\"; see tactics list braille", language.substr(0, 80)));
    for (const BrailleTable& table : tables) braille.only.push_back(table.name);
}

std::vector<Wanted> wanted_of(const Given& given) {
    std::vector<Wanted> wanted;
    std::vector<std::string_view> names;
    for (const Group& group : groups()) names.push_back(group.name);
    for (const auto& word : given.words) {
        if (const Group* group = find_group(word); group != nullptr)
            wanted.push_back({group});
        else if (!wanted.empty() && wanted.back().group->name == "braille")
            take_language(wanted.back(), word);
        else
            throw Error(Fault::usage, "list",
                        phrase("there is no list \"{0}\"{1}; see tactics list", word.substr(0, 80), did_you_mean(word, names)));
    }
    if (given.words.empty())
        for (const Group& group : groups()) wanted.push_back({&group});
    return wanted;
}

std::vector<Entry> entries_of(const Wanted& wanted) {
    std::vector<Entry> all = all_entries(*wanted.group);
    if (wanted.only.empty()) return all;
    std::vector<Entry> some;
    for (const std::string& name : wanted.only)
        for (const Entry& entry : all)
            if (entry.name == name) some.push_back(entry);
    return some;
}

int run_list(const Given& given) {
    const std::vector<Wanted> wanted = wanted_of(given);
    std::string text;
    for (const Wanted& one : wanted) {
        const Group* group = one.group;
        const bool headed = wanted.size() > 1 && !given.has("--json");
        if (headed) text += (text.empty() ? "" : "\n") + std::string(group->name) + ": " + std::string(group->summary) + "\n";
        for (const Entry& entry : entries_of(one))
            text += given.has("--json")
                        ? entry_json(*group, entry)
                        : (headed ? "  " : "") + std::string(entry.name) + ": " + std::string(entry.summary) + entry.tail + "\n";
    }
    if (given.has("--json"))
        print_out(text);
    else
        print_help(text);
    return 0;
}

}  // namespace

extern const Command list_command;
const Command list_command{
    .name = "list",
    .summary =
        "list the commands, recipes, filters, formats, embossers, displays, media, papers, cells, braille tables, readers, "
        "rules and help topics",
    .words = "[GROUP...] [LANGUAGE]",
    .details =
        "Each line gives a name and says what it is. Without GROUP, all groups are listed: commands, recipes, filters, formats, "
        "embossers, displays, media, papers, cells, braille, readers, rules, topics. After braille, a language, such as de or "
        "german, lists its tables alone.",
    .example = "tactics list filters\ntactics list formats papers --json\ntactics list braille de",
    .flags = kListFlags,
    .offers = "groups",
    .run = run_list,
};

}  // namespace tactics
