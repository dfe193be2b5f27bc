// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/cups_filter.h"

#include <sys/auxv.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "cli/interrupt.h"
#include "cli/report/say.h"
#include "cli/verbs/ppd.h"
#include "filters/list.h"
#include "tactics/error.h"
#include "tactics/job/holds.h"
#include "tactics/job/make_pages.h"
#include "tactics/job/open_input.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// What the PPD file says of the machine, then what the print job asks for besides.
struct Queue {
    const Format* embosser = nullptr;
    Wishes wishes;
};

std::string without_quotes(std::string_view text) {
    while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.remove_suffix(1);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return std::string(text);
}

// "*Key: value" lines; CUPS sets a queue's own defaults in the file itself.
std::vector<std::pair<std::string, std::string>> read_ppd(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw Error(Fault::failed, path, "cannot be read; set the queue up again with a PPD file of tactics ppd");
    std::vector<std::pair<std::string, std::string>> lines;
    for (std::string line; std::getline(file, line) && lines.size() < 10'000;) {
        const auto colon = line.find(": ");
        if (line.empty() || line[0] != '*' || colon == std::string::npos) continue;
        lines.emplace_back(line.substr(1, colon - 1), without_quotes(std::string_view(line).substr(colon + 2)));
    }
    return lines;
}

// What is said last counts.
void take(Queue& queue, const std::string& name, const std::string& value) {
    Wishes& wishes = queue.wishes;
    if (name == "PageSize" || name == "media" || name == "PageRegion") {
        if (const std::string paper = paper_of_ppd(value.substr(0, value.find(','))); !paper.empty())
            wishes.paper = find_paper(paper, name);
    } else if (name == "TacticsRecipe") {
        wishes.chain.base.reset();
        if (value != "auto") wishes.chain.base = find_recipe(value, name);
    } else if (name == "TacticsBraille") {
        wishes.sheet.braille_table = value == "none" ? "" : value;
    } else if (name == "TacticsWords") {
        wishes.words = find_words_wish(value, name);
    } else {
        for (const Option& option : queue.embosser->options)
            if (name == ppd_name_of(option)) wishes.settings.front().second.set(option.name, value, name, queue.embosser->name);
    }
}

Queue queue_of(const std::string& ppd, std::string_view options) {
    const auto lines = read_ppd(ppd);
    Queue queue;
    for (const auto& [key, value] : lines)
        if (key == "TacticsEmbosser") queue.embosser = find_format(value);
    if (queue.embosser == nullptr || queue.embosser->embosser == nullptr)
        throw Error(Fault::failed, ppd, "names no embosser; set the queue up again with a PPD file of tactics ppd");
    queue.wishes.settings.push_back({queue.embosser, Settings(queue.embosser->options)});
    constexpr std::string_view kDefault = "Default";
    for (const auto& [key, value] : lines)
        if (std::string_view(key).starts_with(kDefault)) take(queue, key.substr(kDefault.size()), value);
    for (const auto& [name, value] : parse_cups_options(options)) take(queue, name, value);
    return queue;
}

// CUPS shows the last of these beside the print job.
std::string_view words_of(JobStep step) {
    switch (step) {
        case JobStep::reading: return "reading";
        case JobStep::drawing: return "drawing";
        case JobStep::laying_out: return "laying out";
        case JobStep::writing: return "sending";
    }
    return "";
}

// The file of a source once more, from its beginning.
Source again(const Source& source) {
    Source copy = open_source("/dev/fd/" + std::to_string(fileno(source.file.get())));
    copy.name = source.name;
    return copy;
}

int emboss_all(Source source, const Queue& queue, int copies) {
    const bool pdf = look_at(source) == Holds::pdf;
    const int pages = pdf ? pages_of_pdf(source) : 1;
    const Job job{source.name, {{queue.embosser, "-", ""}}};
    for (int copy = 0; copy < copies; ++copy)
        for (int page = 1; page <= pages; ++page) {
            const std::string name = "page " + std::to_string(page) + " of " + std::to_string(pages);
            const Watch watch{.goes_on = [&](JobStep step) {
                say("INFO: " + std::string(words_of(step)) + " " + name);
                return true;
            }};
            std::vector<std::string> notes;
            Source input = page_of_input(again(source), source.name, pdf ? page : 0, notes);
            const Outcome outcome = make_pages(std::move(input), job, queue.wishes, watch);
            for (const std::string& note : outcome.notes) say("INFO: " + note);
            if (!outcome.error.empty()) throw Error(outcome.fault, "", outcome.error);
            say("PAGE: " + std::to_string(copy * pages + page) + " 1");
        }
    return 0;
}

}  // namespace

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

bool is_called_by_cups() {
    const auto* path = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
    return path != nullptr && std::filesystem::path(path).filename() == kCupsFilterName;
}

int run_cups_filter(std::span<const std::string> words) {
    try {
        if (words.size() != 5 && words.size() != 6)
            throw Error(Fault::usage, std::string(kCupsFilterName),
                        "is called by CUPS with job, user, title, copies, options and perhaps a file; to use it yourself: "
                        "tactics convert");
        const char* ppd = std::getenv("PPD");
        if (ppd == nullptr) throw Error(Fault::failed, "PPD", "CUPS names no PPD file; set the queue up with one of tactics ppd");
        const Queue queue = queue_of(ppd, words[4]);
        // With a file the filter makes the copies, else what comes after it (filter(7)).
        const int copies = words.size() == 6 ? static_cast<int>(std::clamp(parse_number(words[3]).value_or(1), 1.0, 1000.0)) : 1;
        const Interrupt interrupt([] {});
        return emboss_all(open_source(words.size() == 6 ? words[5] : "-"), queue, copies);
    } catch (const std::exception& error) {
        say("ERROR: " + std::string(error.what()));
        return 1;
    }
}

}  // namespace tactics
