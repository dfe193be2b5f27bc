// SPDX-License-Identifier: Apache-2.0
#include "cli/help/catalogue.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "cli/command.h"
#include "cli/help/thing_texts.h"
#include "cli/help/topics.h"
#include "cli/kept_recipes.h"
#include "print/embosser.h"
#include "print/format.h"
#include "tactics/braille/tables.h"
#include "tactics/confidence.h"
#include "tactics/error.h"
#include "tactics/job/disk.h"
#include "tactics/readers/read.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

std::vector<Entry> command_entries() {
    std::vector<Entry> entries;
    for (const Command* command : commands())
        entries.push_back({command->name, command->summary, [command] { return explain_command(*command); }});
    return entries;
}

std::vector<Entry> recipe_entries() {
    std::vector<Entry> entries{
        {"auto", "looks at the picture and chooses one of the others (the default)", [] {
             return std::string(
                 "tactics reports the choice on standard error. It depends on the picture alone, not on the "
                 "page.\n");
         }}};
    for (const NamedRecipe& recipe : named_recipes())
        entries.push_back({recipe.name, recipe.summary, [&recipe] { return describe_recipe(recipe); }});
    return entries;
}

// The kept recipes, as strings that live as long as the program.
std::vector<Entry> kept_recipe_entries() {
    struct Told {
        KeptRecipe recipe;
        std::string summary, text;
    };
    static const std::vector<Told> kTold = [] {
        std::vector<Told> all;
        for (KeptRecipe& kept : kept_recipes()) {
            Told told{std::move(kept), "", ""};
            try {
                const Recipe recipe = parse_recipe(real_disk().read_text(told.recipe.file), told.recipe.file, filters());
                told.summary = recipe.summary.empty() ? "a recipe of your own, kept with the defaults" : recipe.summary;
                told.text = to_text(recipe);
            } catch (const Error& error) {
                told.summary = std::string("it cannot be used: ") + error.what();
            }
            all.push_back(std::move(told));
        }
        return all;
    }();
    std::vector<Entry> entries;
    for (const Told& told : kTold)
        entries.push_back(
            {told.recipe.name,
             told.summary,
             [&told] { return "It is " + told.recipe.file + (told.text.empty() ? "" : ":\n" + indent(told.text)) + "\n"; },
             {},
             " (" + told.recipe.file + ")",
             [&told](JsonObject& json) { json.add("file", told.recipe.file); }});
    return entries;
}

std::vector<Entry> filter_entries() {
    std::vector<Entry> entries;
    for (const Filter* filter : filters())
        entries.push_back({filter->name, filter->summary, [filter] { return describe_filter(*filter); }, filter->options});
    return entries;
}

std::vector<Entry> formats_that(bool (*fit)(const Format& format), std::string (*describe)(const Format& format)) {
    std::vector<Entry> entries;
    for (const Format* format : formats())
        if (fit(*format))
            entries.push_back({format->name, format->summary, [format, describe] { return describe(*format); }, format->options});
    return entries;
}

std::vector<Entry> format_entries() {
    return formats_that([](const Format& format) { return format.embosser == nullptr; }, describe_format);
}

// With the models, by which a machine may be named, too.
std::vector<Entry> machine_entries(bool (*fit)(const Format& format)) {
    std::vector<Entry> entries = formats_that(fit, describe_embosser);
    for (Entry& entry : entries) {
        const std::string_view called = find_format(entry.name)->embosser->called;
        if (called.empty()) continue;
        std::vector<std::string> models;
        for (const std::string_view model : words_of(called)) models.emplace_back(model);
        entry.tail = "; called " + std::string(called);
        entry.json = [models](JsonObject& json) { json.add_raw("models", json_text_array(models)); };
    }
    return entries;
}

std::vector<Entry> embosser_entries() {
    return machine_entries(
        [](const Format& format) { return format.embosser != nullptr && format.embosser->display == nullptr; });
}

std::vector<Entry> display_entries() {
    return machine_entries(
        [](const Format& format) { return format.embosser != nullptr && format.embosser->display != nullptr; });
}

// Entries of an array of things with a name and a summary.
template <class Thing>
std::vector<Entry> entries_of(std::span<const Thing> things, std::string (*describe)(const Thing& thing)) {
    std::vector<Entry> entries;
    for (const Thing& thing : things)
        entries.push_back({thing.name, thing.summary, [&thing, describe] { return describe(thing); }});
    return entries;
}

std::vector<Entry> medium_entries() { return entries_of(media(), describe_medium); }
std::vector<Entry> paper_entries() { return entries_of(papers(), describe_paper); }
std::vector<Entry> cell_entries() { return entries_of(cells(), describe_cell); }

// The installed tables of liblouis, as strings that live as long as the program.
std::vector<Entry> braille_entries() {
    struct Told {
        BrailleTable table;
        std::string summary;
    };
    static const std::vector<Told> kTables = [] {
        std::vector<Told> all;
        for (BrailleTable& table : described_tables()) {
            std::string summary = words_of(table);
            all.push_back({std::move(table), std::move(summary)});
        }
        return all;
    }();
    std::vector<Entry> entries;
    for (const Told& told : kTables)
        entries.push_back({told.table.name,
                           told.summary,
                           [&told] { return describe_braille_table(told.table); },
                           {},
                           {},
                           [&told](JsonObject& json) {
                               json.add_raw("languages", json_text_array(told.table.languages));
                               json.add("grade", told.table.grade);
                               json.add("type", told.table.type);
                               json.add("dots", told.table.dots);
                               json.add("title", told.table.title);
                           }});
    return entries;
}

std::vector<Entry> reader_entries() {
    std::vector<Entry> entries;
    for (const Reader* reader : readers())
        entries.push_back({reader->name, reader->summary, [reader] {
                               return "File names usually end in " + std::string(reader->extensions) +
                                      "; the contents of a file decide, not its name.\n";
                           }});
    return entries;
}

std::vector<Entry> rule_entries() {
    std::vector<Entry> entries;
    for (const Rule* rule : rules())
        entries.push_back({rule->name,
                           rule->summary,
                           [rule] { return describe_rule(*rule); },
                           {&rule->limit, 1},
                           {},
                           [rule](JsonObject& json) {
                               json.add_raw("hard", rule->hard ? "true" : "false");
                               json.add("confidence", name_of(rule->confidence));
                               json.add("source", rule->source);
                           }});
    return entries;
}

std::vector<Entry> topic_entries() {
    std::vector<Entry> entries;
    for (const Topic& topic : topics()) entries.push_back({topic.name, topic.summary, topic.text});
    return entries;
}

void add_names(std::vector<std::string>& names, std::string_view owner, std::span<const Option> options) {
    for (const Option& option : options) names.push_back(std::string(owner) + "." + std::string(option.name));
}

}  // namespace

std::span<const Group> groups() {
    using enum Group::Settings;
    static constexpr Group kGroups[] = {
        {.name = "commands",
         .singular = "command",
         .summary = "what the program does",
         .entries = command_entries,
         .begins_with_text = true},
        {.name = "recipes",
         .singular = "recipe",
         .summary = "chains of filters that come with the program, then your own",
         .entries = recipe_entries,
         .kept = kept_recipe_entries},
        {"filters", "filter", "single steps from a picture to a drawing", filter_entries, in_manual},
        {"formats", "format", "kinds of files that tactics writes", format_entries, in_manual},
        {"embossers", "embosser", "braille embossers that tactics writes files for: NAME:FILE", embosser_entries, listed},
        {"displays", "display", "pin displays that tactics writes files for: NAME:FILE, or shows pictures on", display_entries,
         listed},
        {"media", "medium", "what a page is made on; decides how wide and how far apart lines are", medium_entries},
        {"papers", "paper", "sizes of sheets", paper_entries},
        {"cells", "cell", "sizes of braille", cell_entries},
        {.name = "braille",
         .singular = "braille table",
         .summary = "installed braille tables, with language and grade: --braille NAME",
         .entries = braille_entries,
         .installed = true},
        {"readers", "reader", "kinds of pictures that tactics reads", reader_entries},
        {"rules", "rule", "what check measures on a page, and the limits", rule_entries, in_manual},
        {.name = "topics",
         .singular = "topic",
         .summary = "other topics that help explains",
         .entries = topic_entries,
         .text_in_manual = true},
    };
    return kGroups;
}

std::vector<Entry> all_entries(const Group& group) {
    std::vector<Entry> entries = group.entries();
    if (group.kept == nullptr) return entries;
    std::vector<Entry> kept = group.kept();
    std::move(kept.begin(), kept.end(), std::back_inserter(entries));
    return entries;
}

const Group* find_group(std::string_view name) {
    for (const Group& group : groups())
        if (group.name == name) return &group;
    return nullptr;
}

std::vector<std::string> setting_names() {
    std::vector<std::string> names;
    for (const Filter* filter : filters()) add_names(names, filter->name, filter->options);
    for (const Format* format : formats()) add_names(names, format->name, format->options);
    return names;
}

std::vector<std::string> limit_names() {
    std::vector<std::string> names;
    for (const Rule* rule : rules()) add_names(names, rule->name, {&rule->limit, 1});
    return names;
}

}  // namespace tactics
