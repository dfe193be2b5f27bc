// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/print_options.h"

#include <algorithm>

#include "cli/sheet_values.h"
#include "cli/verbs/ppd.h"
#include "filters/list.h"
#include "print/embosser.h"
#include "tactics/braille/braille.h"
#include "tactics/braille/tables.h"
#include "tactics/error.h"
#include "tactics/job/placed_words.h"
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
                phrase("this queue offers no such choice; lpoptions -p QUEUE -l lists them, and a queue of an older PPD file is "
                       "set up again with one of tactics ppd"));
}

std::string table_of(const std::string& value) {
    const auto tables = braille_tables();
    if (std::find(tables.begin(), tables.end(), value) == tables.end())
        throw Error(Fault::usage, "TacticsBraille",
                    phrase("liblouis has no such table; set the queue up again with a PPD file of tactics ppd"));
    return value;
}

// Words, and never a file of them: "30%,40%=City Park;60%,20%=Lake".
void take_labels(Queue& queue, std::string_view text) {
    queue.labels.clear();
    for (std::size_t number = 1; !text.empty(); ++number) {
        const auto end = std::min(text.find(';'), text.size());
        const std::string_view one = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (one.empty()) continue;
        const std::string origin = "TacticsLabels " + std::to_string(number);
        const auto equals = one.find('=');
        if (equals == std::string_view::npos || number > kMostLabels)
            throw Error(
                Fault::usage, origin,
                phrase("it is a place with words, such as 30%,40%=City Park, a semicolon between one and the next, at most {0}",
                       std::to_string(kMostLabels)));
        queue.labels.push_back(label_of(one.substr(0, equals), one.substr(equals + 1), origin));
    }
}

// A language brings its own table unless one is named.
void take_table_of(Wishes& wishes) {
    if (wishes.sheet.language == Sheet{}.language) return;
    if (const std::string table = table_for_tag(wishes.sheet.language, described_tables()); !table.empty())
        wishes.sheet.braille_table = table;
}

constexpr std::string_view kOfLanguage = "auto";

// Options for the drawing and the words beside it. False: it is none of these.
bool take_words(const PpdWords& ppd, Queue& queue, const std::string& name, const std::string& value, const std::string& job) {
    Wishes& wishes = queue.wishes;
    if (name == "TacticsLanguage") {
        check_offered(ppd, name, value);
        wishes.sheet.language = language_of(value, name);
    } else if (name == "TacticsDetail") {
        check_offered(ppd, name, value);
        wishes.chain.detail = value == "touch" ? "" : value;
        wishes.chain.as_drawn = value == "contours";
    } else if (name == "TacticsTitle") {
        wishes.sheet.title = value == "none" ? "" : value == "job" ? job : value;
        wishes.sheet.title_origin = name;
    } else if (name == "TacticsLabels") {
        take_labels(queue, value);
    } else {
        return false;
    }
    return true;
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
        if (value != kOfLanguage) wishes.sheet.braille_table = value == "none" ? "" : table_of(value);
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

Queue queue_of(const PpdWords& ppd, const std::string& place, const PrintOptions& options, const std::string& name) {
    Queue queue;
    queue.embosser = find_format(ppd.embosser);
    if (queue.embosser == nullptr || queue.embosser->embosser == nullptr)
        throw Error(Fault::failed, place, phrase("names no embosser; set the queue up again with a PPD file of tactics ppd"));
    queue.wishes.settings.push_back({queue.embosser, Settings(queue.embosser->options)});
    // A language in the job brings its braille table, unless the job names one; the queue's table applies only to the queue's
    // language.
    std::string table(kOfLanguage);
    const auto take_all = [&](const auto& wishes) {
        for (const auto& [option, value] : wishes) {
            if (option == "TacticsBraille") table = value;
            if (option == "TacticsLanguage" && value != queue.wishes.sheet.language) table = kOfLanguage;
        }
        for (const auto& [option, value] : wishes)
            if (!take_words(ppd, queue, option, value, name)) take(ppd, queue, option, value);
    };
    take_all(ppd.defaults);
    take_all(options);
    if (table == kOfLanguage) take_table_of(queue.wishes);
    return queue;
}

PrintOptions parse_cups_options(std::string_view text) {
    PrintOptions options;
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
