// SPDX-License-Identifier: Apache-2.0
#include "cli/cups_filter.h"

#include <sys/auxv.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "cli/command.h"
#include "cli/ppd.h"
#include "cli/request.h"
#include "cli/say.h"
#include "tactics/error.h"
#include "tactics/job/conversion.h"
#include "tactics/job/figure.h"
#include "tactics/job/open_input.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// What the PPD file says of the machine, then what the job asks for besides.
struct Wishes {
    const Format* embosser = nullptr;
    std::map<std::string, std::string> flags;     // of tactics convert; what is said last counts
    std::map<std::string, std::string> settings;  // of --set
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

void take(Wishes& wishes, const std::string& name, const std::string& value) {
    if (name == "PageSize" || name == "media" || name == "PageRegion") {
        if (const std::string paper = paper_of_ppd(value.substr(0, value.find(','))); !paper.empty())
            wishes.flags["--paper"] = paper;
    } else if (name == "TacticsRecipe") {
        wishes.flags["--recipe"] = value;
    } else if (name == "TacticsBraille") {
        wishes.flags["--braille"] = value;
    } else if (name == "TacticsWords") {
        wishes.flags["--words"] = value;
    } else {
        for (const Option& option : wishes.embosser->options)
            if (name == ppd_name_of(option))
                wishes.settings[std::string(wishes.embosser->name) + "." + std::string(option.name)] = value;
    }
}

Wishes wishes_of(const std::string& ppd, std::string_view options) {
    const auto lines = read_ppd(ppd);
    Wishes wishes;
    for (const auto& [key, value] : lines)
        if (key == "TacticsEmbosser") wishes.embosser = find_format(value);
    if (wishes.embosser == nullptr || wishes.embosser->embosser == nullptr)
        throw Error(Fault::failed, ppd, "names no embosser; set the queue up again with a PPD file of tactics ppd");
    constexpr std::string_view kDefault = "Default";
    for (const auto& [key, value] : lines)
        if (std::string_view(key).starts_with(kDefault)) take(wishes, key.substr(kDefault.size()), value);
    for (const auto& [name, value] : parse_cups_options(options)) take(wishes, name, value);
    return wishes;
}

int convert_job(const std::string& path, const Wishes& wishes, int copies) {
    int pages = 1;
    bool pdf = false;
    {
        const Source source = open_source(path);
        pdf = look_at(source.file.get()) == Holds::pdf;
    }
    if (pdf) pages = pages_of_pdf(path);
    const Command& convert = *find_command("convert");
    for (int copy = 0; copy < copies; ++copy)
        for (int page = 1; page <= pages; ++page) {
            std::vector<std::string> words{path, "-o", std::string(wishes.embosser->name) + ":-"};
            for (const auto& [flag, value] : wishes.flags) words.insert(words.end(), {flag, value});
            for (const auto& [setting, value] : wishes.settings) words.insert(words.end(), {"--set", setting + "=" + value});
            if (pdf) words.insert(words.end(), {"--page", std::to_string(page)});
            const Request request = plan(parse_words(convert, words), real_disk());
            WriteGate gate;
            const Outcome outcome = convert_picture(request, request.jobs.front(), gate);
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
        const Wishes wishes = wishes_of(ppd, words[4]);
        // With a file the filter makes the copies, else what comes after it (filter(7)).
        const int copies = words.size() == 6 ? static_cast<int>(std::clamp(parse_number(words[3]).value_or(1), 1.0, 1000.0)) : 1;
        if (words.size() == 6) return convert_job(words[5], wishes, copies);
        const Source job = open_source("-");
        return convert_job(name_for_others("-", job), wishes, 1);
    } catch (const std::exception& error) {
        say("ERROR: " + std::string(error.what()));
        return 1;
    }
}

}  // namespace tactics
