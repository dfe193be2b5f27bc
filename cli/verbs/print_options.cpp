// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/print_options.h"

#include <algorithm>

#include "cli/verbs/ppd.h"
#include "filters/list.h"
#include "print/embosser.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr std::size_t kMostLines = 10'000;

std::string without_quotes(std::string_view text) {
    text = trimmed(text);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return std::string(text);
}

// A file is never named: what is offered is one word of the list.
void check_offered(const PpdWords& ppd, const std::string& name, const std::string& value) {
    const auto offered = ppd.choices.find(name);
    if (offered != ppd.choices.end() && offered->second.contains(value)) return;
    throw Error(Fault::usage, name,
                "this queue offers no such choice; lpoptions -p QUEUE -l lists them, and a queue of an older PPD file is set up "
                "again with one of tactics ppd");
}

std::string table_of(const std::string& value) {
    const auto tables = braille_tables();
    if (std::find(tables.begin(), tables.end(), value) == tables.end())
        throw Error(Fault::usage, "TacticsBraille",
                    "liblouis has no such table; set the queue up again with a PPD file of tactics ppd");
    return value;
}

// What is said last counts.
void take(const PpdWords& ppd, Queue& queue, const std::string& name, const std::string& value) {
    Wishes& wishes = queue.wishes;
    if (name == "PageSize" || name == "media" || name == "PageRegion") {
        if (const std::string paper = paper_of_ppd(value.substr(0, value.find(','))); !paper.empty())
            wishes.paper = find_paper(paper, name);
    } else if (name == "TacticsRecipe") {
        check_offered(ppd, name, value);
        wishes.chain.base.reset();
        if (value != "auto") wishes.chain.base = find_recipe(value, name);
    } else if (name == "TacticsBraille") {
        check_offered(ppd, name, value);
        wishes.sheet.braille_table = value == "none" ? "" : table_of(value);
    } else if (name == "TacticsWords") {
        wishes.words = find_words_wish(value, name);
    } else {
        for (const Option& option : queue.embosser->options)
            if (name == ppd_name_of(option)) wishes.settings.front().second.set(option.name, value, name, queue.embosser->name);
    }
}

}  // namespace

PpdWords parse_ppd(std::string_view text) {
    constexpr std::string_view kDefault = "Default";
    PpdWords ppd;
    for (std::size_t lines = 0; !text.empty() && lines < kMostLines; ++lines) {
        const auto end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const auto colon = line.find(':');
        if (line.empty() || line[0] != '*' || colon == std::string_view::npos) continue;
        const std::string_view key = line.substr(1, colon - 1);
        if (const auto blank = key.find(' '); blank != std::string_view::npos) {
            const std::string_view choice = trimmed(key.substr(blank));
            ppd.choices[std::string(key.substr(0, blank))].emplace(choice.substr(0, choice.find('/')));
        } else if (key == "TacticsEmbosser") {
            ppd.embosser = without_quotes(line.substr(colon + 1));
        } else if (key.starts_with(kDefault)) {
            ppd.defaults.emplace_back(key.substr(kDefault.size()), without_quotes(line.substr(colon + 1)));
        }
    }
    return ppd;
}

Queue queue_of(const PpdWords& ppd, const std::string& place, std::string_view options) {
    Queue queue;
    queue.embosser = find_format(ppd.embosser);
    if (queue.embosser == nullptr || queue.embosser->embosser == nullptr)
        throw Error(Fault::failed, place, "names no embosser; set the queue up again with a PPD file of tactics ppd");
    queue.wishes.settings.push_back({queue.embosser, Settings(queue.embosser->options)});
    for (const auto& [name, value] : ppd.defaults) take(ppd, queue, name, value);
    for (const auto& [name, value] : parse_cups_options(options)) take(ppd, queue, name, value);
    return queue;
}

std::vector<std::pair<std::string, std::string>> parse_cups_options(std::string_view text) {
    std::vector<std::pair<std::string, std::string>> options;
    std::size_t at = 0;
    while (at < text.size()) {
        if (text[at] == ' ' || text[at] == '\t') {
            ++at;
            continue;
        }
        std::string name, value;
        bool has_value = false;
        char quote = '\0';
        for (; at < text.size(); ++at) {
            const char c = text[at];
            std::string& part = has_value ? value : name;
            if (c == '\\' && at + 1 < text.size())
                part += text[++at];
            else if (quote != '\0' && c == quote)
                quote = '\0';
            else if (quote != '\0')
                part += c;
            else if (c == '\'' || c == '"')
                quote = c;
            else if (c == ' ' || c == '\t')
                break;
            else if (c == '=' && !has_value)
                has_value = true;
            else
                part += c;
        }
        if (!has_value) {
            const bool no = name.starts_with("no") && name.size() > 2;
            value = no ? "false" : "true";
            if (no) name = name.substr(2);
        }
        options.emplace_back(std::move(name), std::move(value));
    }
    return options;
}

}  // namespace tactics
