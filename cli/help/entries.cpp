// SPDX-License-Identifier: Apache-2.0
#include "cli/help/entries.h"

#include <stdexcept>

#include "cli/command.h"
#include "cli/help/topics.h"
#include "filters/list.h"
#include "print/embosser.h"
#include "print/format.h"
#include "tactics/medium.h"
#include "tactics/readers/read.h"
#include "tactics/rules/rule.h"

namespace tactics {

std::span<const Group> groups() {
    static constexpr Group kGroups[] = {
        {"commands", "command", "what the program does"},
        {"recipes", "recipe", "chains of filters that come with the program"},
        {"filters", "filter", "steps from a picture to a drawing"},
        {"formats", "format", "kinds of files that can be written"},
        {"embossers", "embosser", "machines whose bytes can be written: NAME:FILE"},
        {"displays", "display", "pin displays whose bytes can be written: NAME:FILE, or show"},
        {"media", "medium", "what is printed on; it decides how wide and how far apart lines are"},
        {"papers", "paper", "sizes of sheets"},
        {"cells", "cell", "sizes of braille"},
        {"readers", "reader", "kinds of pictures that can be read"},
        {"rules", "rule", "what check measures on a page"},
        {"topics", "topic", "what help explains besides"},
    };
    return kGroups;
}

const Group* find_group(std::string_view name) {
    for (const Group& group : groups())
        if (group.name == name) return &group;
    return nullptr;
}

std::vector<Entry> entries_of(std::string_view group) {
    std::vector<Entry> entries;
    const auto add = [&](const auto& item) { entries.push_back({item.name, item.summary}); };
    if (group == "commands") {
        for (const Command* command : commands()) add(*command);
    } else if (group == "recipes") {
        entries.push_back({"auto", "looks at the picture and chooses one of the others (the default)"});
        for (const NamedRecipe& recipe : named_recipes()) add(recipe);
    } else if (group == "filters") {
        for (const Filter* filter : filters()) add(*filter);
    } else if (group == "formats") {
        for (const Format* format : formats())
            if (format->embosser == nullptr) add(*format);
    } else if (group == "embossers") {
        for (const Format* format : formats())
            if (format->embosser != nullptr && format->embosser->display == nullptr) add(*format);
    } else if (group == "displays") {
        for (const Format* format : formats())
            if (format->embosser != nullptr && format->embosser->display != nullptr) add(*format);
    } else if (group == "media") {
        for (const Medium& medium : media()) add(medium);
    } else if (group == "papers") {
        for (const Paper& paper : papers()) add(paper);
    } else if (group == "cells") {
        for (const NamedCell& cell : cells()) add(cell);
    } else if (group == "readers") {
        for (const Reader* reader : readers()) add(*reader);
    } else if (group == "rules") {
        for (const Rule* rule : rules()) add(*rule);
    } else if (group == "topics") {
        for (const Topic& topic : topics()) add(topic);
    } else {
        throw std::logic_error("no group " + std::string(group));
    }
    return entries;
}

std::vector<std::string> setting_names() {
    std::vector<std::string> names;
    const auto add = [&](const auto& owner) {
        for (const Option& option : owner.options) names.push_back(std::string(owner.name) + "." + std::string(option.name));
    };
    for (const Filter* filter : filters()) add(*filter);
    for (const Format* format : formats()) add(*format);
    return names;
}

std::vector<std::string> limit_names() {
    std::vector<std::string> names;
    for (const Rule* rule : rules()) names.push_back(std::string(rule->name) + "." + std::string(rule->limit.name));
    return names;
}

}  // namespace tactics
